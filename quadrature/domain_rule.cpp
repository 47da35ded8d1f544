#include "quadrature/domain_rule.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "quadrature/compensated_sum.hpp"
#include "quadrature/compression.hpp"
#include "quadrature/cut_cell.hpp"

namespace rfm {
namespace {

template <class Include>
double sum_of_weights(const SurfacePoints& points, Include&& include) {
  CompensatedSum sum;
  for (int i = 0; i < points.size(); ++i)
    if (include(points.numbers[i])) sum.add(points.weights[i]);
  return sum.value();
}

// The cell to which a surface point found in `cell` belongs. On a side of the cell with the inside
// beyond it, that is the neighbour.
int inner_cell(const Grid& grid, const std::vector<CellState>& states, int cell, const Point& point,
               const Point& normal) {
  std::array<int, 3> position = grid.position(cell);
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    const double same = 1e-12 * grid.spacing(axis);
    const int low = position[axis];
    if (normal[axis] > 0 && low > 0 && std::fabs(point[axis] - grid.line(axis, low)) <= same)
      --position[axis];
    else if (normal[axis] < 0 && low + 1 < grid.cells(axis) &&
             std::fabs(point[axis] - grid.line(axis, low + 1)) <= same)
      ++position[axis];
  }
  const int inner = grid.number(position);
  return states[inner] == CellState::outside ? cell : inner;
}

// Sorts the points by the cell to which they belong, keeping their order within a cell.
SurfaceRule sorted_by_cell(const Grid& grid, const std::vector<CellState>& states,
                           const SurfacePoints& points, const std::vector<int>& found_in) {
  std::vector<int> owner(points.size()), order(points.size());
  for (int i = 0; i < points.size(); ++i) {
    owner[i] = inner_cell(grid, states, found_in[i], points.point(i), points.normal(i));
    order[i] = i;
  }
  std::ranges::stable_sort(order, {}, [&](int i) { return owner[i]; });
  SurfaceRule rule;
  rule.points.reserve(grid.dimension(), points.size());
  for (const int i : order) {
    if (rule.cells.empty() || rule.cells.back() != owner[i]) {
      rule.cells.push_back(owner[i]);
      rule.begin.push_back(rule.points.size());
    }
    rule.points.add(grid.dimension(), points.point(i), points.normal(i), points.weights[i],
                    points.numbers[i]);
    rule.begin.back() = rule.points.size();
  }
  return rule;
}

// Quadrature cells reach beyond the grid by rounding; points do not.
template <class Points>
void move_into(const Box& box, Points& points) {
  for (int axis = 0; axis < box.dimension; ++axis)
    for (double& x : points.coordinates[axis]) x = std::clamp(x, box.low[axis], box.high[axis]);
}

}  // namespace

double SurfaceRule::measure() const {
  return sum_of_weights(points, [](int) { return true; });
}

double SurfaceRule::measure(int number) const {
  return sum_of_weights(points, [&](int other) { return other == number; });
}

double DomainRule::measure() const {
  double cell = 1;
  for (int axis = 0; axis < dimension(); ++axis) cell *= grid_.spacing(axis);
  CompensatedSum sum;
  sum.add(cell * static_cast<double>(inside_cells_.size()));
  for (const double weight : cut_points_.weights) sum.add(weight);
  return sum.value();
}

void DomainRule::add_inside_points(int cell, VolumePoints& points) const {
  const Box box = grid_.cell(grid_.position(cell));
  add_tensor_rule(box, inside_rule(), [&](const Point& point, double weight) {
    points.add(dimension(), point, weight);
  });
}

class DomainRuleBuilder {
 public:
  DomainRuleBuilder(const RegionEvaluator& region, const Grid& grid,
                    const QuadratureOptions& options, const Interfaces& interfaces)
      : options_(options),
        classification_(classify_cells(region, grid, interfaces, Classification::loose)),
        surfaces_(region, interfaces),
        breakpoints_(surfaces_.breakpoints(options.breakpoints)),
        rule_(grid) {
    rule_.inside_points_ = options.inside_points;
    // Throw for numbers out of range before work starts.
    gauss_legendre(options.inside_points);
    gauss_legendre(options.cut_points);
    for (const Grading& grading : options.gradings) check(grading);
    for (int axis = 0; axis < grid.dimension(); ++axis)
      spacing_ = std::max(spacing_, grid.spacing(axis));
  }

  DomainRule run() {
    rule_.states_ = classification_.states;
    list_tasks();
    // Small parts of fixed size: the result is the same for any number of threads.
    constexpr std::size_t part_size = 16;
    std::vector<Part> parts((tasks_.size() + part_size - 1) / part_size);
    tbb::enumerable_thread_specific<Worker> workers([&] {
      return Worker{Subdivision(options_.subdivision), {}};
    });
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
      const std::size_t first = p * part_size;
      const std::size_t last = std::min(first + part_size, tasks_.size());
      Worker& worker = workers.local();
      worker.rule.volume.clear();
      worker.rule.boundary.clear();
      worker.rule.interfaces.clear();
      for (std::size_t t = first; t < last; ++t) integrate(tasks_[t], worker, parts[p].results);
      parts[p].volume = worker.rule.volume;
      parts[p].boundary = worker.rule.boundary;
      parts[p].interfaces = worker.rule.interfaces;
    });
    gather(parts);
    write_report();
    return std::move(rule_);
  }

 private:
  // A cell with points of its own; `cut_cell` counts the cut cells of the classification, and is −1
  // for a cell inside that is split at breakpoints or graded.
  struct Task {
    int cell;
    int cut_cell;
  };
  struct TaskResult {
    CellReport report;
    CellState state;
    int volume_points, boundary_points, interface_points;
    double fraction;
  };
  // What a thread uses again and again: points are made in memory that is there already, and copied
  // when it is known how many there are.
  struct Worker {
    Subdivision subdivision;
    CellRule rule;
  };
  struct Part {
    VolumePoints volume;
    SurfacePoints boundary, interfaces;
    std::vector<TaskResult> results;
  };

  void list_tasks() {
    int next_cut = 0;
    const bool any = !options_.gradings.empty() ||
                     std::ranges::any_of(breakpoints_, [](const auto& b) { return !b.empty(); });
    const int cells = rule_.grid_.cell_count();
    for (int cell = 0; cell < cells; ++cell) {
      if (rule_.states_[cell] == CellState::cut) tasks_.push_back({cell, next_cut++});
      if (any && rule_.states_[cell] == CellState::inside &&
          is_split_cell(rule_.grid_.cell(rule_.grid_.position(cell))))
        tasks_.push_back({cell, -1});
    }
  }

  // At breakpoints or by gradings.
  bool is_split_cell(const Box& cell) const {
    return is_split(cell, breakpoints_) || is_graded(cell, options_.gradings, spacing_);
  }

  void drop_singular_points(CellRule& rule, int volume, int boundary) const {
    for (const Grading& grading : options_.gradings) {
      const auto singular = [&](const auto& points) {
        return [&](int i) { return lies_on(grading, rule_.dimension(), points.point(i)); };
      };
      rule.volume.erase_if(volume, singular(rule.volume));
      rule.boundary.erase_if(boundary, singular(rule.boundary));
    }
  }

  void integrate(const Task& task, Worker& worker, std::vector<TaskResult>& results) const {
    CellRule& rule = worker.rule;
    rule.uncertified = {};
    rule.order_difference = {};
    const int volume = rule.volume.size(), boundary = rule.boundary.size(),
              interfaces = rule.interfaces.size();
    const auto position = rule_.grid_.position(task.cell);
    const Box cell = rule_.grid_.cell(position);
    const Box whole = quadrature_cell(rule_.grid_, position);
    bool is_full = false;
    // Graded parts are tiny, and have surfaces like any other.
    constexpr double least_share = 0.02;
    const auto add_part = [&](const Box& box, const ActiveSet& active) {
      rule.is_full = false;
      add_cell_rule(box, active,
                    {options_.cut_points, options_.compare_orders, options_.inside_points,
                     std::max(box.measure() / whole.measure(), least_share)},
                    worker.subdivision, rule);
      is_full = rule.is_full && whole.low == box.low && whole.high == box.high;
    };
    const auto add = [&](const Box& box, const ActiveSet& active) {
      if (options_.gradings.empty()) return add_part(box, active);
      visit_graded_parts(box, options_.gradings, spacing_,
                         [&](const Box& part) { add_part(part, active); });
    };
    if (task.cut_cell < 0) {
      surfaces_.visit_inside_cell(cell, breakpoints_, add);
    } else {
      rule.uncertified +=
          surfaces_.visit_cut_cell(classification_, task.cut_cell, whole, breakpoints_, add);
    }
    drop_singular_points(rule, volume, boundary);
    CompensatedSum measure;
    for (int i = volume; i < rule.volume.size(); ++i) measure.add(rule.volume.weights[i]);
    const double fraction = measure.value() / cell.measure();
    const bool split = is_split_cell(cell) || rule.interfaces.size() > interfaces;
    // A cell that is full up to rounding, as at a face on its side, is inside.
    constexpr double rounding = 1e-14;
    CellState state = CellState::cut;
    if (rule.volume.size() == volume) state = CellState::outside;
    if (!split && (is_full || fraction > 1 - rounding)) state = CellState::inside;
    if (state == CellState::inside) rule.volume.resize(volume);
    if (options_.compress_cut_cells && state == CellState::cut && !split) {
      const int dimension = rule_.dimension();
      compress(dimension, compressed_degree(options_.cut_points, dimension), volume, rule.volume);
    }
    results.push_back({{task.cell, rule.uncertified, rule.order_difference},
                       state,
                       rule.volume.size() - volume,
                       rule.boundary.size() - boundary,
                       rule.interfaces.size() - interfaces,
                       fraction});
  }

  void gather(std::vector<Part>& parts) {
    SurfacePoints boundary, interfaces;
    std::vector<int> boundary_cells, interface_cells;
    std::size_t task = 0;
    gather_volume(parts);
    rule_.report_.cells.reserve(tasks_.size());
    for (Part& part : parts) {
      for (const TaskResult& result : part.results) {
        const int cell = tasks_[task++].cell;
        add(result.report);
        rule_.states_[cell] = result.state;
        boundary_cells.insert(boundary_cells.end(), result.boundary_points, cell);
        interface_cells.insert(interface_cells.end(), result.interface_points, cell);
        if (result.state != CellState::cut) continue;
        rule_.cut_cells_.push_back(cell);
        rule_.cut_begin_.push_back(rule_.cut_begin_.back() + result.volume_points);
        rule_.report_.smallest_cut_fraction =
            std::min(rule_.report_.smallest_cut_fraction, result.fraction);
      }
      boundary.append(part.boundary);
      interfaces.append(part.interfaces);
      part = {};
    }
    const int cells = rule_.grid_.cell_count();
    for (int cell = 0; cell < cells; ++cell)
      if (rule_.states_[cell] == CellState::inside) rule_.inside_cells_.push_back(cell);
    const Box& box = rule_.grid_.box();
    move_into(box, boundary);
    move_into(box, interfaces);
    rule_.boundary_ = sorted_by_cell(rule_.grid_, rule_.states_, boundary, boundary_cells);
    rule_.interfaces_ = sorted_by_cell(rule_.grid_, rule_.states_, interfaces, interface_cells);
  }

  void add(const CellReport& cell) {
    QuadratureReport& report = rule_.report_;
    report.uncertified += cell.uncertified;
    report.order_difference.volume += cell.order_difference.volume;
    report.order_difference.boundary += cell.order_difference.boundary;
    report.cells.push_back(cell);
  }

  // The points of all cut cells, array by array, which is mostly time to touch new memory.
  void gather_volume(std::vector<Part>& parts) {
    const int dimension = rule_.dimension();
    std::size_t count = 0;
    for (const Part& part : parts) count += part.volume.weights.size();
    tbb::parallel_for(0, dimension + 1, [&](int i) {
      const auto array = [&](VolumePoints& points) -> std::vector<double>& {
        return i < dimension ? points.coordinates[i] : points.weights;
      };
      std::vector<double>& all = array(rule_.cut_points_);
      all.reserve(count);
      for (Part& part : parts) {
        const std::vector<double> own = std::move(array(part.volume));
        all.insert(all.end(), own.begin(), own.end());
      }
    });
    move_into(rule_.grid_.box(), rule_.cut_points_);
  }

  void write_report() {
    QuadratureReport& report = rule_.report_;
    report.inside_cells = static_cast<int>(rule_.inside_cells_.size());
    report.cut_cells = static_cast<int>(rule_.cut_cells_.size());
    const Point center = rule_.grid_.box().center();
    CompensatedSum flux;
    const SurfacePoints& points = rule_.boundary_.points;
    for (int axis = 0; axis < rule_.dimension(); ++axis)
      for (int i = 0; i < points.size(); ++i)
        flux.add(points.weights[i] * points.normals[axis][i] *
                 (points.coordinates[axis][i] - center[axis]));
    report.divergence_defect = std::fabs(flux.value() / rule_.dimension() - rule_.measure());
  }

  const QuadratureOptions& options_;
  CellClassification classification_;
  CellSurfaces surfaces_;
  Breakpoints breakpoints_;
  double spacing_ = 0;  // the longest side of a cell
  DomainRule rule_;
  std::vector<Task> tasks_;
};

DomainRule make_domain_rule(const RegionEvaluator& region, const Grid& grid,
                            const QuadratureOptions& options, const Interfaces& interfaces) {
  return DomainRuleBuilder(region, grid, options, interfaces).run();
}

}  // namespace rfm
