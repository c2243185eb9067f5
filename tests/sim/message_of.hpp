#pragma once

#include <exception>
#include <string>

namespace nadir::sim::support {

/// What an action says when it throws; "(nothing thrown)" if it does not.
template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "(nothing thrown)";
}

}  // namespace nadir::sim::support
