// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSSING_FACES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSSING_FACES_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Bounding_box.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Point_grid.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/power_of_two_unit.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Corner_table.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossings.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_handle_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// All pairs of faces that cross each other, by a grid of cells with the faces whose boxes meet them. Where the faces of a cell hang
// together and look much the same way, they are one sheet, which does not cross itself; that is nearly everywhere. Where faces differ
// too much in size for a grid, CGAL's intersection of boxes takes its place.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The handle leads to the face's place in a list.
using Box_of_face =
  CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Corner_table::Index*, CGAL::Box_intersection_d::ID_FROM_HANDLE>;

// Whether two faces cross each other, and how far what may cross reaches beyond the boxes of the faces.
template <class Surface>
struct Crossing_of_faces
{
  const Surface& mesh;

  double growth(Corner_table::Index) const { return 0; }
  bool operator()(Corner_table::Index f, Corner_table::Index g) const { return cross_each_other(mesh, f, g); }
};

template <class Surface, class Crossing>
std::vector<Box_of_face> boxes_of_faces(const Surface& mesh, const std::vector<Corner_table::Index>& faces, const Crossing& crossing)
{
  std::vector<Box_of_face> result;
  result.reserve(faces.size());
  for (const Corner_table::Index& f : faces) {
    const Bounding_box b = bounding_box(mesh, f);
    const double g = crossing.growth(f);
    result.emplace_back(CGAL::Bbox_3(b.low.x - g, b.low.y - g, b.low.z - g, b.high.x + g, b.high.y + g, b.high.z + g), &f);
  }
  return result;
}

// `Surface` is a `Corner_table` with position(), `Crossing` like Crossing_of_faces.
template <class ConcurrencyTag, class Surface, class Crossing>
class Crossing_finder
{
  using Index = Corner_table::Index;

  // The size of a cell, in mean extents of the boxes of faces: from 2.2 to 3.2 the search takes as long, with less longer.
  static constexpr double CELL = 2.4;
  // It is not less than this; the extent of the mesh is about 1.
  static constexpr double SMALLEST_CELL = 1e-8;
  // Cells grow until they hold no more entries than this for each face: faces may differ much in size.
  static constexpr double MOST_ENTRIES = 8;
  // The normals of a sheet make less than 60 degrees with their mean.
  static constexpr double SHEET_COSINE = 0.5;
  // More faces than these are no sheet, but the fan of a vertex or cells of one hash.
  static constexpr std::size_t LARGEST_SHEET = 64;
  // Where larger cells have more pairs of faces than so many for each face of the mesh, the sizes differ too much for a grid: to look
  // for a face among the boxes takes as long as to compare so many.
  static constexpr double MOST_PAIRS = 200;

  struct Rounded_box
  {
    std::array<float, 3> low, high;
  };

public:
  Crossing_finder(const Surface& mesh, const Crossing& crossing)
    : mesh_(mesh), crossing_(crossing)
  {}

  // Every pair once, the lower number first, in order.
  std::vector<std::pair<Index, Index>> find()
  {
    std::vector<std::pair<Index, Index>> result;
    // Of the mesh and its surface; a projector of the user's may have led further away than rounded boxes are good for.
    constexpr double LARGEST_EXTENT = 2;
    list_faces();
    if (faces_.empty()) return result;
    const bool has_cells = larger_extent(0, box_.high - box_.low) <= LARGEST_EXTENT;
    if (has_cells) { round_boxes(); fill_cells(); }
    if (!has_cells || are_cells_crowded()) find_by_boxes(result);
    else
      scan_into<ConcurrencyTag>(result, start_.size() - 1, [&](std::size_t cell, std::vector<std::pair<Index, Index>>& found) {
        find_in_cell(entries_.data() + start_[cell], start_[cell + 1] - start_[cell], found);
      });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  void list_faces()
  {
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f) {
      if (!mesh_.is_face(f)) continue;
      for (const Index v : mesh_.face_record(f).vertex) box_ += mesh_.position(v);
      faces_.push_back(f);
    }
  }

  // The faces' normals and boxes; these are seen from the lowest corner of all, and as much too large as they may have been rounded.
  void round_boxes()
  {
    constexpr double ROUNDING = 2e-7;
    boxes_.resize(faces_.size());
    normals_.resize(faces_.size());
    for_each_block<ConcurrencyTag>(faces_.size(), SCAN_BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index* v = corners(Index(i));
        const Vector3 a = mesh_.position(v[0]) - box_.low, b = mesh_.position(v[1]) - box_.low, c = mesh_.position(v[2]) - box_.low;
        normals_[i] = triangle_cross(a, b, c);
        const Bounding_box box(a, b, c);
        const double least[3] = {box.low.x, box.low.y, box.low.z}, most[3] = {box.high.x, box.high.y, box.high.z};
        const double growth = crossing_.growth(faces_[i]) + ROUNDING;
        for (int k = 0; k < 3; ++k) {
          boxes_[i].low[k] = float((std::max)(0., least[k] - growth));
          boxes_[i].high[k] = float(most[k] + growth);
        }
      }
    });
  }

  // Faces by cell, cells by hash: start_ has the first entry of each.
  void fill_cells()
  {
    double extents = 0;
    for (const Rounded_box& b : boxes_)
      for (int k = 0; k < 3; ++k) extents += double(b.high[k] - b.low[k]);
    double cell = (std::max)(SMALLEST_CELL, CELL * extents / (3 * double(boxes_.size())));
    while (number_of_entries(cell) > MOST_ENTRIES * double(boxes_.size())) cell *= 1.5;
    inverse_cell_ = 1 / cell;
    std::size_t size = 1;
    while (size < 2 * boxes_.size()) size *= 2;
    start_.assign(size + 1, 0);
    for (const Rounded_box& b : boxes_) for_each_cell(b, [&](std::size_t c) { ++start_[c]; });
    for (std::size_t c = 0; c < size; ++c) start_[c + 1] += start_[c];     // where each ends, until it is filled
    entries_.resize(start_[size]);
    for (std::size_t i = boxes_.size(); i-- > 0;) for_each_cell(boxes_[i], [&](std::size_t c) { entries_[--start_[c]] = Index(i); });
  }

  double number_of_entries(double cell) const
  {
    const double inverse = 1 / cell;
    double result = 0;
    for (const Rounded_box& b : boxes_) {
      double cells = 1;
      for (int k = 0; k < 3; ++k) cells *= 1 + inverse * double(b.high[k] - b.low[k]);
      result += cells;
    }
    return result;
  }

  template <class Function>
  void for_each_cell(const Rounded_box& b, const Function& function) const
  {
    Grid_cell low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] = std::int64_t(double(b.low[k]) * inverse_cell_);
      high[k] = std::int64_t(double(b.high[k]) * inverse_cell_);
    }
    for (Grid_cell c = low; c[0] <= high[0]; ++c[0])
      for (c[1] = low[1]; c[1] <= high[1]; ++c[1])
        for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) function(hash_of_cell(c) & (start_.size() - 2));
  }

  bool are_cells_crowded() const
  {
    double pairs = 0;
    for (std::size_t c = 0; c + 1 < start_.size(); ++c)
      if (const double n = start_[c + 1] - start_[c]; n > LARGEST_SHEET) pairs += n * n / 2;
    return pairs > MOST_PAIRS * double(faces_.size());
  }

  // Slower, but for faces of any sizes.
  void find_by_boxes(std::vector<std::pair<Index, Index>>& found) const
  {
    std::vector<Box_of_face> boxes = boxes_of_faces(mesh_, faces_, crossing_);
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box_of_face& a, const Box_of_face& b) {
      const Index f = *a.handle(), g = *b.handle();
      if (crossing_(f, g)) found.emplace_back((std::min)(f, g), (std::max)(f, g));
    });
  }

  void find_in_cell(const Index* entry, std::size_t n, std::vector<std::pair<Index, Index>>& found) const
  {
    if (n < 2 || is_sheet(entry, n)) return;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        if (entry[i] == entry[j] || !overlap(boxes_[entry[i]], boxes_[entry[j]])) continue;
        const Index f = faces_[entry[i]], g = faces_[entry[j]];
        if (crossing_(f, g)) found.emplace_back((std::min)(f, g), (std::max)(f, g));
      }
  }

  static bool overlap(const Rounded_box& a, const Rounded_box& b)
  {
    float gap = 0;
    for (int k = 0; k < 3; ++k) gap = (std::max)(gap, (std::max)(a.low[k] - b.high[k], b.low[k] - a.high[k]));
    return !(gap > 0);
  }

  // Whether these faces look the same way and hang together by their vertices. Two flaps of a border may overlap.
  bool is_sheet(const Index* entry, std::size_t n) const
  {
    if (n > LARGEST_SHEET) return false;
    Vector3 normal;
    for (std::size_t i = 0; i < n; ++i) {
      if (is_on_border(faces_[entry[i]])) return false;
      normal += normals_[entry[i]];
    }
    for (std::size_t i = 0; i < n; ++i)
      if (!is_cosine_at_least(normals_[entry[i]], normal, SHEET_COSINE)) return false;
    std::array<Index, LARGEST_SHEET> waiting;
    Vertex_set met(n);
    met.insert(corners(entry[0]));
    std::size_t left = n - 1;
    std::copy(entry + 1, entry + n, waiting.begin());
    for (std::size_t before = left + 1; left > 0 && left < before;) {
      before = left;
      const auto end = std::remove_if(waiting.begin(), waiting.begin() + std::ptrdiff_t(left), [&](Index i) {
        if (!met.has_one_of(corners(i))) return false;
        met.insert(corners(i));
        return true;
      });
      left = std::size_t(end - waiting.begin());
    }
    return left == 0;
  }

  bool is_on_border(Index f) const { return mesh_.is_border(4 * f) || mesh_.is_border(4 * f + 1) || mesh_.is_border(4 * f + 2); }
  const Index* corners(Index i) const { return mesh_.face_record(faces_[i]).vertex; }

  // Of the corners of a sheet of so many faces: a table with open addressing.
  class Vertex_set
  {
  public:
    explicit Vertex_set(std::size_t faces)
    {
      while (size_ <= 3 * faces) size_ *= 2;
      std::fill_n(slots_.begin(), size_, -1);
    }
    void insert(const Index* corner) { for (int k = 0; k < 3; ++k) slots_[find(corner[k])] = corner[k]; }
    bool has_one_of(const Index* corner) const
    {
      return std::any_of(corner, corner + 3, [&](Index v) { return slots_[find(v)] == v; });
    }

  private:
    static constexpr std::size_t LARGEST_SIZE = 256;
    static_assert(LARGEST_SIZE > 3 * LARGEST_SHEET, "the table has room for all corners");

    std::size_t find(Index v) const
    {
      std::size_t i = std::size_t(v) & (size_ - 1);
      while (slots_[i] >= 0 && slots_[i] != v) i = (i + 1) & (size_ - 1);
      return i;
    }
    std::size_t size_ = 8;               // of what is used: a power of two
    std::array<Index, LARGEST_SIZE> slots_;
  };

  const Surface& mesh_;
  const Crossing& crossing_;
  Bounding_box box_;                             // of all faces
  double inverse_cell_ = 1;
  std::vector<Index> faces_;
  std::vector<Rounded_box> boxes_;               // by number in faces_, as the normals and the entries
  std::vector<Vector3> normals_;
  std::vector<std::uint32_t> start_;
  std::vector<Index> entries_;
};

template <class ConcurrencyTag, class Surface, class Crossing>
std::vector<std::pair<Corner_table::Index, Corner_table::Index>> crossing_faces(const Surface& surface, const Crossing& crossing)
{
  return Crossing_finder<ConcurrencyTag, Surface, Crossing>(surface, crossing).find();
}

template <class ConcurrencyTag, class Surface>
std::vector<std::pair<Corner_table::Index, Corner_table::Index>> crossing_faces(const Surface& surface)
{
  return crossing_faces<ConcurrencyTag>(surface, Crossing_of_faces<Surface>{surface});
}

// The pairs of one of `faces` and one of `others` that cross each other, in order; of two that are in both lists, both pairs.
template <class Surface>
std::vector<std::pair<Corner_table::Index, Corner_table::Index>> crossing_faces(const Surface& surface,
                                                                                const std::vector<Corner_table::Index>& faces,
                                                                                const std::vector<Corner_table::Index>& others)
{
  std::vector<std::pair<Corner_table::Index, Corner_table::Index>> result;
  const Crossing_of_faces<Surface> crossing{surface};
  std::vector<Box_of_face> boxes = boxes_of_faces(surface, faces, crossing), boxes_of_others = boxes_of_faces(surface, others, crossing);
  CGAL::box_intersection_d(boxes.begin(), boxes.end(), boxes_of_others.begin(), boxes_of_others.end(),
                           [&](const Box_of_face& a, const Box_of_face& b) {
    const Corner_table::Index f = *a.handle(), g = *b.handle();
    if (f != g && crossing(f, g)) result.emplace_back(f, g);
  });
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_MESH_CROSSING_FACES_H
