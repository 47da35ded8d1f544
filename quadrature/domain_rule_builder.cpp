// How a DomainRule is made: tasks of cells in parallel, gathered in the order of the cells.

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "quadrature/cell_surfaces.hpp"
#include "quadrature/compression.hpp"
#include "quadrature/cut_cell.hpp"
#include "quadrature/flush_faces.hpp"
#include "quadrature/rule_parts.hpp"

namespace rfm {

namespace {

void check(const SubdivisionOptions& options) {
  if (options.max_work <= 0) throw InvalidArgument("the work for a cell is positive");
  for (const int depth : options.max_depth)
    if (depth < 0) throw InvalidArgument("the depth of bisections is not negative");
  for (const double flatness : options.flatness)
    if (!(flatness >= 0 && flatness <= 1)) throw InvalidArgument("flatness lies between 0 and 1");
  if (!(options.flatness_decay > 0 && options.flatness_decay <= 1))
    throw InvalidArgument("the decay of flatness lies between 0 and 1");
}

}  // namespace

class DomainRuleBuilder {
 public:
  DomainRuleBuilder(const RegionEvaluator& region, const Grid& grid,
                    const QuadratureOptions& options, const Interfaces& interfaces)
      : options_(options),
        classification_(classify_cells(region, grid, interfaces, Classification::loose)),
        surfaces_(region, interfaces),
        flush_faces_(region),
        breakpoints_(surfaces_.breakpoints(options.breakpoints)),
        rule_(grid) {
    rule_.inside_points_ = options.inside_points;
    // Throw for numbers out of range before work starts.
    gauss_legendre(options.inside_points);
    gauss_legendre(options.cut_points);
    for (const Grading& grading : options.gradings) check(grading);
    check(options.subdivision);
    for (const auto& places : options.breakpoints)
      for (const double place : places)
        if (!std::isfinite(place)) throw InvalidArgument("a breakpoint is a finite number");
    for (int axis = 0; axis < grid.dimension(); ++axis)
      spacing_ = std::max(spacing_, grid.largest_width(axis));
  }

  DomainRule run() {
    rule_.states_ = classification_.states;
    list_tasks();
    // Small parts of fixed size: the result is the same for any number of threads.
    constexpr std::size_t part_size = 16;
    std::vector<RulePart> parts((tasks_.size() + part_size - 1) / part_size);
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
      for (std::size_t t = first; t < last; ++t) integrate(tasks_[t], worker, parts[p]);
      parts[p].take(rule_.grid_.box(), worker.rule);
    });
    write_report(parts);
    gather(parts);
    return std::move(rule_);
  }

 private:
  // A cell with points of its own; `cut_cell` counts the cut cells of the classification, and is −1
  // for a cell inside that is split at breakpoints or graded.
  struct Task {
    int cell;
    int cut_cell;
  };
  // What a thread uses again and again: points are made in memory that is there already, and copied
  // when it is known how many there are.
  struct Worker {
    Subdivision subdivision;
    CellRule rule;
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

  void integrate(const Task& task, Worker& worker, RulePart& part) const {
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
    if (!flush_faces_.empty())
      rule.boundary.erase_if(boundary, [&](int i) {
        return flush_faces_.is_crack(rule.boundary.numbers[i], rule.boundary.point(i));
      });
    CompensatedSum measure = sum_of_weights(rule.volume, volume);
    const double fraction = measure.value() / cell.measure();
    const bool split = is_split_cell(cell) || rule.interfaces.size() > interfaces;
    // A cell that is full up to rounding, as at a face on its side, is inside.
    constexpr double rounding = 1e-14;
    CellState state = CellState::cut;
    if (rule.volume.size() == volume) state = CellState::outside;
    if (!split && (is_full || fraction > 1 - rounding)) state = CellState::inside;
    if (state == CellState::inside) {
      rule.volume.resize(volume);
      measure = {};
    }
    if (options_.compress_cut_cells && state == CellState::cut && !split) {
      const int dimension = rule_.dimension();
      compress(dimension, compressed_degree(options_.cut_points, dimension), volume, rule.volume);
      measure = sum_of_weights(rule.volume, volume);
    }
    part.measure.add(measure);
    part.cells.push_back({{task.cell, rule.uncertified, rule.order_difference},
                          state,
                          rule.volume.size() - volume,
                          rule.boundary.size() - boundary,
                          rule.interfaces.size() - interfaces,
                          fraction});
  }

  static CompensatedSum sum_of_weights(const VolumePoints& points, int begin) {
    CompensatedSum sum;
    for (int i = begin; i < points.size(); ++i) sum.add(points.weights[i]);
    return sum;
  }

  void write_report(std::span<const RulePart> parts) {
    QuadratureReport& report = rule_.report_;
    report.cells.reserve(tasks_.size());
    CompensatedSum measure, flux;
    for (const RulePart& part : parts) {
      measure.add(part.measure);
      flux.add(part.flux);
      for (const CellContribution& cell : part.cells) {
        report.uncertified += cell.report.uncertified;
        report.order_difference.volume += cell.report.order_difference.volume;
        report.order_difference.boundary += cell.report.order_difference.boundary;
        report.order_difference.interfaces += cell.report.order_difference.interfaces;
        report.cells.push_back(cell.report);
        rule_.states_[cell.report.cell] = cell.state;
        if (cell.state != CellState::cut) continue;
        rule_.cut_cells_.push_back(cell.report.cell);
        rule_.cut_begin_.push_back(rule_.cut_begin_.back() + cell.volume_points);
        report.smallest_cut_fraction = std::min(report.smallest_cut_fraction, cell.fraction);
      }
    }
    const Grid& grid = rule_.grid_;
    for (int cell = 0; cell < grid.cell_count(); ++cell)
      if (rule_.states_[cell] == CellState::inside) rule_.inside_cells_.push_back(cell);
    if (grid.is_uniform())
      measure.add(grid.cell_measure(0) * static_cast<double>(rule_.inside_cells_.size()));
    else
      for (const int cell : rule_.inside_cells_) measure.add(grid.cell_measure(cell));
    report.inside_cells = static_cast<int>(rule_.inside_cells_.size());
    report.cut_cells = static_cast<int>(rule_.cut_cells_.size());
    report.divergence_defect = std::fabs(flux.value() / grid.dimension() - measure.value());
  }

  void gather(std::span<RulePart> parts) {
    rule_.cut_points_ = joined_volume(rule_.dimension(), parts);
    rule_.boundary_ = joined_surface(rule_.grid_, rule_.states_, parts, &RulePart::boundary,
                                     &CellContribution::boundary_points);
    rule_.interfaces_ = joined_surface(rule_.grid_, rule_.states_, parts, &RulePart::interfaces,
                                       &CellContribution::interface_points);
  }

  const QuadratureOptions& options_;
  CellClassification classification_;
  CellSurfaces surfaces_;
  FlushFaces flush_faces_;
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
