#pragma once

#include <vector>

#include "atmosphere/make/lane_views.hpp"
#include "atmosphere/make/table_job.hpp"

namespace nadir::atmosphere {

/// Lays out a table's axes for a job and puts solved lanes into it. Lanes may be put from several
/// threads at once.
class TableFiller {
 public:
  explicit TableFiller(const TableJob& job);

  [[nodiscard]] std::size_t lanes() const noexcept { return table_.lanes.size(); }
  [[nodiscard]] const Shells& shells() const noexcept { return shells_; }
  [[nodiscard]] LaneFields solved(std::size_t lane, SolveCounts& counts) const;
  void put(std::size_t lane, const LaneFields& fields);
  [[nodiscard]] AirTable take();
  [[nodiscard]] const AirTable& table() const noexcept { return table_; }
  [[nodiscard]] const std::vector<BodyPlace>& places() const noexcept { return places_; }

 private:
  void choose_bodies();
  void keep_body(std::size_t index);
  void size_arrays(std::size_t kinds);
  void put_body(std::size_t lane, const LaneFields& fields, const LaneFields::Beam& beam,
                const LaneView& sky);
  void put_fluxes(std::size_t lane, const LaneFields& fields);
  void put_phases(std::size_t lane, const LaneFields& fields);
  void drop_empty_night();
  [[nodiscard]] double irradiance(std::size_t body, std::size_t lane) const;

  const TableJob& job_;
  Shells shells_;
  AirTable table_;
  ViewShape sky_;
  std::vector<ViewShape> views_;
  std::vector<std::size_t> kept_;  // bodies of the job that are bodies of the table
  std::vector<BodyPlace> places_;  // by body of the table
  std::vector<double> decline_;    // by body of the table: of its light in deep twilight
};

}  // namespace nadir::atmosphere
