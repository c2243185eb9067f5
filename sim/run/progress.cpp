#include "sim/run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace nadir::sim {

std::string readable_duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

Progress::Style Progress::style_for(std::FILE* stream, bool quiet) {
  if (quiet) return Style::none;
  return isatty(fileno(stream)) == 1 ? Style::bar : Style::lines;
}

Progress::Progress(std::FILE* stream, Style style) : stream_{stream}, style_{style} {}

void Progress::update(std::size_t done, std::size_t all) {
  if (style_ == Style::none || all == 0) return;
  const double share = static_cast<double>(done) / static_cast<double>(all);
  const auto now = Clock::now();
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const std::string time_left = readable_duration(elapsed_s * (1.0 - share) / share);
  if (style_ == Style::lines) {
    const int tenth = static_cast<int>(share * 10.0);
    if (tenth == last_tenth_) return;
    last_tenth_ = tenth;
    fmt::print(stream_, "rendering: {:3} %, {} left\n", tenth * 10, time_left);
    std::fflush(stream_);
    return;
  }
  // Ten pictures a second are enough for the eye and cost nothing.
  if (done < all && now - last_drawn_ < std::chrono::milliseconds{100}) return;
  last_drawn_ = now;
  draw_bar(share, time_left);
  if (done == all) fmt::print(stream_, "\n");
}

void Progress::draw_bar(double share, const std::string& time_left) {
  constexpr int width = 40;
  const int filled = static_cast<int>(share * width);
  fmt::print(stream_, "\rrendering [{:=<{}}{: <{}}] {:3.0f} %  {} left   ", "", filled, "",
             width - filled, share * 100.0, time_left);
  std::fflush(stream_);
}

}  // namespace nadir::sim
