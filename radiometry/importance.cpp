#include "radiometry/importance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "radiometry/nonnegative_factorisation.hpp"

namespace nadir::radiometry {
namespace {

// Views. An anisotropic material has more than twice as many of them as an isotropic one, few as
// they are: what a table costs is proportional to their number.
constexpr int isotropic_mus = 24, anisotropic_mus = 10, anisotropic_azimuths = 6;

/// Every quad gets this share of the mean importance at least.
constexpr double floor_share = 0.02;
/// Views of less albedo say nothing about lobes, nor do those below this cosine: all lobes are
/// narrow there, and such views make up mu^2 = 1 % of the projected hemisphere.
constexpr double dark_albedo = 1e-4, grazing_mu = 0.1;
/// Share of its view's importance that a quad must carry to tell a narrow lobe from a dim one.
constexpr double telling_share = 0.05;
/// A quad of less than this share of the mean importance keeps its first two points, and so does
/// one whose larger value exceeds their mean by less than the second factor.
constexpr double refined_share = 0.5, noticeable = 1.4;
/// Cells whose maximum exceeds their mean by this factor are cut again: the cosine alone never
/// does.
constexpr double uneven = 2.0;
/// Cuts in half, of cells around a likely direction and of others. 2^-12 of a quad each way, 1e-4
/// rad, resolves a lobe of roughness 1e-4, the smallest that a microfacet model takes.
constexpr int likely_cuts = 24, other_cuts = 2;

/// A direction where a lobe may be, and its value.
struct Probe {
  Vec3 direction;
  double value;
};

/// Part of a quad, or all of it.
struct Cell {
  int quad = 0;
  Vec2 corner{0.0, 0.0};
  Vec2 size{1.0, 1.0};

  [[nodiscard]] Vec2 at(double x, double y) const noexcept {
    return {corner.x + x * size.x, corner.y + y * size.y};
  }
  [[nodiscard]] Cell half(bool along_x, int number) const noexcept {
    Cell cell = *this;
    (along_x ? cell.size.x : cell.size.y) *= 0.5;
    cell.corner.x += along_x ? cell.size.x * number : 0.0;
    cell.corner.y += along_x ? 0.0 : cell.size.y * number;
    return cell;
  }
};

/// Quads counted from the azimuth of the view.
QuadTurn turned_to(Vec3 wo) noexcept {
  const double sine = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  return sine > 0.0 ? QuadTurn{wo.x / sine, wo.y / sine, 1.0} : QuadTurn{};
}

/// Mean and maximum of what one view gets from each quad.
class QuadStatistics {
 public:
  QuadStatistics(const ImportanceSource& source, const QuadHemisphere& quads, Vec3 wo)
      : source_{source},
        quads_{quads},
        wo_{wo},
        turn_{turned_to(wo)},
        count_{source.transmits ? quads.count_of_both_sides() : quads.count()},
        means_(static_cast<std::size_t>(count_)),
        maxima_(static_cast<std::size_t>(count_)) {
    find_probes();
    for (int quad = 0; quad < count_; ++quad) {
      if (!copies_twin(quad)) mean_at(quad) = glance(quad);
    }
    const double bound = refined_share * total() / count_;
    for (int quad = 0; quad < count_; ++quad) {
      if (copies_twin(quad)) continue;
      const bool varies = mean_at(quad) > bound && maximum_at(quad) > noticeable * mean_at(quad);
      if (varies || probe_near({.quad = quad})) mean_at(quad) = mean({.quad = quad}, likely_cuts);
    }
    for (int quad = 0; quad < count_; ++quad) {
      if (!copies_twin(quad)) continue;
      mean_at(quad) = mean_at(twin(quad));
      maximum_at(quad) = maximum_at(twin(quad));
    }
  }

  [[nodiscard]] const std::vector<double>& means() const noexcept { return means_; }
  [[nodiscard]] double total() const noexcept {
    double sum = 0.0;
    for (const double mean : means_) sum += mean;
    return sum;
  }
  /// Largest maximum / mean of a quad that carries much.
  [[nodiscard]] double peakedness() const noexcept {
    const double sum = total();
    double peak = 1.0;
    const bool dark = sum * quads_.solid_angle() < dark_albedo;
    if (dark || std::fabs(wo_.z) < grazing_mu) return peak;
    for (std::size_t q = 0; q < means_.size(); ++q) {
      if (means_[q] > telling_share * sum) peak = std::max(peak, maxima_[q] / means_[q]);
    }
    return peak;
  }

 private:
  [[nodiscard]] double& mean_at(int quad) { return means_[static_cast<std::size_t>(quad)]; }
  [[nodiscard]] double& maximum_at(int quad) { return maxima_[static_cast<std::size_t>(quad)]; }

  /// The quad on the other side of the plane of view.
  [[nodiscard]] int twin(int quad) const noexcept {
    const int sector = quad % quads_.phi_samples();
    return quad - sector + quads_.phi_samples() - 1 - sector;
  }
  /// Isotropic surfaces look alike on both sides of the plane of view: half the work.
  [[nodiscard]] bool copies_twin(int quad) const noexcept {
    return !source_.anisotropic && twin(quad) < quad;
  }

  [[nodiscard]] double value(int quad, Vec2 u) {
    const double f = source_.scattered(turn_(quads_.direction(quad, u)), wo_);
    // A number that is none would spoil the whole table; the solvers count such values themselves.
    const double sound = std::isfinite(f) && f > 0.0 ? f : 0.0;
    maximum_at(quad) = std::max(maximum_at(quad), sound);
    return sound;
  }

  /// Two points on the diagonal: exact for what is linear in cosine and azimuth.
  [[nodiscard]] double glance(int quad) {
    return 0.5 * (value(quad, {0.25, 0.25}) + value(quad, {0.75, 0.75}));
  }

  [[nodiscard]] double mean(const Cell& cell, int cuts) {
    double sum = 0.0, largest = 0.0;
    for (const double x : {0.25, 0.75}) {
      for (const double y : {0.25, 0.75}) {
        const double f = value(cell.quad, cell.at(x, y));
        sum += f;
        largest = std::max(largest, f);
      }
    }
    if (cuts <= 0) return 0.25 * sum;
    if (const auto likely = probe_near(cell)) {
      largest = std::max(largest, *likely);
    } else {
      cuts = std::min(cuts, other_cuts);
    }
    if (largest <= uneven * 0.25 * sum) return 0.25 * sum;
    const Vec2 widths = widths_rad(cell);
    const bool along_x = widths.x > widths.y;
    return 0.5 * (mean(cell.half(along_x, 0), cuts - 1) + mean(cell.half(along_x, 1), cuts - 1));
  }

  /// In zenith angle and across: dmu / sin and sin dphi at the centre.
  [[nodiscard]] Vec2 widths_rad(const Cell& cell) const noexcept {
    const double mu = quads_.direction(cell.quad, cell.at(0.5, 0.5)).z;
    const double sine = std::sqrt(std::max(0.0, 1.0 - mu * mu));
    return {cell.size.x / (quads_.mu_samples() * sine),
            cell.size.y * sine * 2.0 * std::numbers::pi / quads_.phi_samples()};
  }

  /// The largest probe in the cell or next to it: within one diagonal of the centre, so that a lobe
  /// on a border, or on the pole where all sectors meet, is resolved by all that share it.
  [[nodiscard]] std::optional<double> probe_near(const Cell& cell) const noexcept {
    const Vec3 centre = turn_(quads_.direction(cell.quad, cell.at(0.5, 0.5)));
    const Vec2 widths = widths_rad(cell);
    const double reach2 = widths.x * widths.x + widths.y * widths.y;
    std::optional<double> largest;
    for (const Probe& probe : probes_) {
      const Vec3 apart = probe.direction - centre;
      if (dot(apart, apart) <= reach2) largest = std::max(largest.value_or(0.0), probe.value);
    }
    return largest;
  }

  void find_probes() {
    add_probe({-wo_.x, -wo_.y, wo_.z});  // mirror
    add_probe(-wo_);                     // straight through
    add_probe(wo_);                      // straight back
    for (int i = 0; source_.likely && i < ImportanceSource::likely_count; ++i) {
      if (const auto direction = source_.likely(wo_, i)) add_probe(*direction);
    }
  }

  void add_probe(Vec3 direction) {
    const bool there = source_.transmits || direction.z * wo_.z > 0.0;
    if (!there || !is_finite(direction)) return;
    const QuadHemisphere::Place at = quads_.place(turn_.back(direction));
    probes_.push_back({direction, value(at.quad, at.u)});
  }

  const ImportanceSource& source_;
  const QuadHemisphere& quads_;
  Vec3 wo_;
  QuadTurn turn_;
  int count_;
  std::vector<double> means_, maxima_;
  std::vector<Probe> probes_;
};

ImportanceSource source_of(const materials::BoundMaterial& material) {
  ImportanceSource source;
  source.scattered = [&material](Vec3 wi, Vec3 wo) {
    return static_cast<double>(materials::eval(material.scattering, wi, wo).mean()) *
           std::fabs(wi.z);
  };
  source.likely = [&material](Vec3 wo, int number) -> std::optional<Vec3> {
    constexpr int count = ImportanceSource::likely_count;
    // Evenly spread in each of the three numbers: a lattice with the steps 1, 3 and 5 of 8.
    const auto step = [](int i) { return (i % count + 0.5) / count; };
    const auto drawn = materials::sample(material.scattering, wo,
                                         {step(number), {step(3 * number), step(5 * number)}});
    if (!drawn || drawn->delta) return std::nullopt;
    return drawn->wi;
  };
  source.transmits = material.traits.transmits;
  source.anisotropic = material.traits.anisotropic;
  return source;
}

double norm_of(const double* values, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += values[i] * values[i];
  return std::sqrt(sum);
}

double sum_of(const double* values, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum += values[i];
  return sum;
}

/// One view as the factors give it, without scale.
std::vector<double> fitted(const NonnegativeFactors& factors, std::size_t view) {
  std::vector<double> row(factors.h.columns, 0.0);
  for (std::size_t k = 0; k < factors.rank; ++k) {
    const double share = factors.w.row(view)[k];
    for (std::size_t q = 0; q < row.size(); ++q) row[q] += share * factors.h.row(k)[q];
  }
  return row;
}

/// Scales the rows of W so that each view has its own total, and says how well the rows then fit:
/// relative root-mean-square error over the views that scatter anything.
double scale_to_totals(NonnegativeFactors& factors, const DenseMatrix& table) {
  double squares = 0.0;
  int lit = 0;
  for (std::size_t view = 0; view < table.rows; ++view) {
    const double* wanted = table.row(view);
    const double norm = norm_of(wanted, table.columns);
    if (norm <= 0.0) continue;
    std::vector<double> fit = fitted(factors, view);
    const double total = sum_of(fit.data(), fit.size());
    const double scale = total > 0.0 ? sum_of(wanted, table.columns) / total : 0.0;
    for (std::size_t q = 0; q < fit.size(); ++q) fit[q] = fit[q] * scale - wanted[q];
    for (std::size_t k = 0; k < factors.rank; ++k) factors.w.row(view)[k] *= scale;
    squares += std::pow(norm_of(fit.data(), fit.size()) / norm, 2);
    ++lit;
  }
  return lit > 0 ? std::sqrt(squares / lit) : 0.0;
}

/// Nodes mu = ((i + 1/2) / (n - 1/2))^2, i = 0 .. n - 1: from grazing to 1.
double node_mu(int i, int count) noexcept {
  const double root = (i + 0.5) / (count - 0.5);
  return root * root;
}

}  // namespace

ImportanceTable::ImportanceTable(const materials::BoundMaterial& material,
                                 const QuadHemisphere& quads, double tolerance)
    : ImportanceTable{source_of(material), quads, tolerance} {}

ImportanceTable::ImportanceTable(const ImportanceSource& source, const QuadHemisphere& quads,
                                 double tolerance)
    : transmits_{source.transmits},
      anisotropic_{source.anisotropic},
      quads_{source.transmits ? quads.count_of_both_sides() : quads.count()},
      sides_{source.transmits ? 2 : 1},
      mus_{source.anisotropic ? anisotropic_mus : isotropic_mus},
      azimuths_{source.anisotropic ? anisotropic_azimuths : 1} {
  tabulate(source, quads, tolerance);
}

bool ImportanceTable::plainly_narrow(const materials::BoundMaterial& material,
                                     const QuadHemisphere& quads) {
  const ImportanceSource source = source_of(material);
  // From slanting, where lobes are narrowest, to steep; azimuths differ for what is anisotropic.
  for (const Vec3 wo : {Vec3{0.9887, 0.0, 0.15}, Vec3{0.0, 0.9798, 0.2}, Vec3{0.6928, 0.6, 0.4},
                        Vec3{0.6, 0.0, 0.8}, Vec3{0.0, 0.0, 1.0}}) {
    if (QuadStatistics{source, quads, wo}.peakedness() > lobe_is_narrow) return true;
    if (!source.transmits) continue;
    if (QuadStatistics{source, quads, -wo}.peakedness() > lobe_is_narrow) return true;
  }
  return false;
}

void ImportanceTable::tabulate(const ImportanceSource& source, const QuadHemisphere& quads,
                               double tolerance) {
  DenseMatrix table{static_cast<std::size_t>(views()), static_cast<std::size_t>(quads_)};
  for (int view = 0; view < views(); ++view) {
    const QuadStatistics statistics{source, quads, view_direction(view)};
    std::copy(statistics.means().begin(), statistics.means().end(),
              table.row(static_cast<std::size_t>(view)));
    peakedness_ = std::max(peakedness_, statistics.peakedness());
  }
  // Bright views must not take all the parts: where samples go matters as much for dark ones.
  DenseMatrix alike = table;
  for (std::size_t view = 0; view < table.rows; ++view) {
    const double norm = norm_of(table.row(view), table.columns);
    if (norm <= 0.0) continue;
    for (std::size_t q = 0; q < table.columns; ++q) alike.row(view)[q] /= norm;
  }
  NonnegativeFactors factors = factorise(alike, {.tolerance = tolerance, .rank_limit = rank_limit});
  error_ = scale_to_totals(factors, table);
  rank_ = static_cast<int>(factors.rank);
  views_.assign(factors.w.values.begin(), factors.w.values.end());
  parts_.assign(factors.h.values.begin(), factors.h.values.end());
  for (std::size_t k = 0; k < factors.rank; ++k) {
    part_means_.push_back(static_cast<float>(sum_of(factors.h.row(k), factors.h.columns) / quads_));
  }
}

Vec3 ImportanceTable::view_direction(int view) const noexcept {
  const int azimuth = view % azimuths_, ring = view / azimuths_;
  const double mu = node_mu(ring % mus_, mus_);
  const double phi = 2.0 * std::numbers::pi * azimuth / azimuths_;
  const double sine = std::sqrt(std::max(0.0, 1.0 - mu * mu));
  return {sine * std::cos(phi), sine * std::sin(phi), ring < mus_ ? mu : -mu};
}

ImportanceTable::Blend ImportanceTable::blend(Vec3 wo) const noexcept {
  const double place = std::clamp(std::sqrt(std::fabs(wo.z)) * (mus_ - 0.5) - 0.5, 0.0, mus_ - 1.0);
  const int lower = std::min(static_cast<int>(place), mus_ - 2);
  const double to_upper = place - lower;
  int first = 0, second = 0;
  double to_second = 0.0;
  if (anisotropic_) {
    const double turns = std::atan2(wo.y, wo.x) / (2.0 * std::numbers::pi) + 1.0;
    const double step = turns * azimuths_;
    first = static_cast<int>(step) % azimuths_;
    second = (first + 1) % azimuths_;
    to_second = step - std::floor(step);
  }
  const int side = transmits_ && wo.z < 0.0 ? mus_ : 0;
  const auto view = [&](int mu, int azimuth) {
    const int index = (side + mu) * azimuths_ + azimuth;
    return static_cast<std::size_t>(index);
  };
  return {
      {view(lower, first), view(lower + 1, first), view(lower, second), view(lower + 1, second)},
      {(1.0 - to_upper) * (1.0 - to_second), to_upper * (1.0 - to_second),
       (1.0 - to_upper) * to_second, to_upper * to_second}};
}

QuadTurn ImportanceTable::turn(Vec3 wo) const noexcept {
  QuadTurn turn = turned_to(wo);
  if (!transmits_ && wo.z < 0.0) turn.side = -1.0;
  return turn;
}

void ImportanceTable::importance(Vec3 wo, double* of_quads) const noexcept {
  const auto count = static_cast<std::size_t>(quads_), rank = static_cast<std::size_t>(rank_);
  std::fill_n(of_quads, count, 0.0);
  const Blend around = blend(wo);
  double mean = 0.0;
  for (std::size_t k = 0; k < rank; ++k) {
    double weight = 0.0;
    for (std::size_t i = 0; i < around.view.size(); ++i) {
      weight += around.share[i] * static_cast<double>(views_[around.view[i] * rank + k]);
    }
    if (weight <= 0.0) continue;
    mean += weight * static_cast<double>(part_means_[k]);
    const float* part = parts_.data() + k * count;
    for (std::size_t q = 0; q < count; ++q) of_quads[q] += weight * static_cast<double>(part[q]);
  }
  const double least = floor_share * mean;
  for (std::size_t q = 0; q < count; ++q) of_quads[q] = std::max(of_quads[q], least);
}

}  // namespace nadir::radiometry
