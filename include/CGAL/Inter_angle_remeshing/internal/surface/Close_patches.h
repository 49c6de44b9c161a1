// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CLOSE_PATCHES_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CLOSE_PATCHES_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Bounding_box.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Corner_table.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/crossing_faces.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

// Where a smooth surface over the faces of another one crosses itself, though these do not: it bulges, and what is close by, another
// sheet or another part, may lie within the bulge.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// The pairs of faces whose patches are close to each other. `Patches` has reference_surface(), point(f, b) for barycentric coordinates b,
// and height(f), how far at most that is from the face.
template <class Patches>
class Close_patches
{
  using Index = Corner_table::Index;
  using Surface = std::decay_t<decltype(std::declval<const Patches&>().reference_surface())>;

  // Patches count as crossing if they did with so many times their height.
  static constexpr double BULGE = 1.25;

public:
  explicit Close_patches(const Patches& patches)
    : patches_(patches), surface_(patches.reference_surface()), growth_(surface_.number_of_faces())
  {
    for (Index f = 0; f < Index(growth_.size()); ++f) growth_[f] = BULGE * patches.height(f);
    pairs_ = crossing_faces<CGAL::Sequential_tag>(surface_, May_cross{*this});
  }

  // Of two faces whose patches cross, though they do not, calls `flatten(f)` for the one that bulges into the other one, or for both: the
  // patch then is the face, and the faces across its edges have other patches, no higher ones, which may cross in their turn. It ends when
  // no patches do, as each face is flattened once.
  template <class Flatten>
  void part(const Flatten& flatten)
  {
    if (pairs_.empty()) return;
    list_pairs_by_face();
    std::vector<std::size_t> waiting(pairs_.size());
    std::iota(waiting.begin(), waiting.end(), std::size_t(0));
    std::vector<char> is_waiting(pairs_.size(), 0);
    const auto renew = [&](Index f) {
      if (slot_[f] < 0) return;
      facets_[slot_[f]] = Facets();
      growth_[f] = BULGE * patches_.height(f);
      for (std::size_t k = first_[f]; k < first_[f + 1]; ++k) {
        if (!is_waiting[pairs_of_face_[k]]) waiting.push_back(pairs_of_face_[k]);
        is_waiting[pairs_of_face_[k]] = 1;
      }
    };
    while (!waiting.empty()) {
      std::vector<Index> bulging;
      for (const std::size_t i : waiting) {
        is_waiting[i] = 0;
        append_bulging(pairs_[i].first, pairs_[i].second, bulging);
      }
      waiting.clear();
      for (const Index f : bulging) {
        if (!(growth_[f] > 0)) continue;
        flatten(f);
        renew(f);
        for (Index h = 4 * f; h < 4 * f + 3; ++h)
          if (surface_.opposite(h) >= 0) renew(surface_.face(surface_.opposite(h)));
      }
    }
  }

private:
  // For Crossing_finder.
  struct May_cross
  {
    const Close_patches& close;

    double growth(Index f) const { return close.growth_[f]; }
    bool operator()(Index f, Index g) const
    {
      const double reach = growth(f) + growth(g);
      return reach > 0 && common_corner(close.surface_, f, g)[0] < 0 && !close.is_beyond(f, g, reach) && !close.is_beyond(g, f, reach);
    }
  };

  // Triangles that stand for a patch which is BULGE times as high, between points whose barycentric coordinates are thirds; just the face
  // where that is flat.
  struct Facets
  {
    std::array<Vector3, 10> points;
    int triangles = 0;                     // 0: not known yet
    Bounding_box box;
  };
  static constexpr int TRIANGLES[9][3] = {{0, 4, 1}, {1, 5, 2}, {2, 6, 3}, {4, 7, 5}, {5, 8, 6}, {7, 9, 8},
                                          {4, 5, 1}, {5, 6, 2}, {7, 8, 5}};

  // Whether the corners of f are farther than this from the plane of g, on one side of it.
  bool is_beyond(Index f, Index g, double distance) const
  {
    const Vector3& normal = surface_.cross_product(g);
    const auto &a = surface_.face_record(f).vertex, &b = surface_.face_record(g).vertex;
    const double bound = distance * length(normal);
    const auto height = [&](Index v) { return dot(surface_.position(v) - surface_.position(b[0]), normal); };
    return std::all_of(a, a + 3, [&](Index v) { return height(v) > bound; }) ||
           std::all_of(a, a + 3, [&](Index v) { return height(v) < -bound; });
  }

  void list_pairs_by_face()
  {
    first_.assign(growth_.size() + 1, 0);
    for (const auto& [f, g] : pairs_) for (const Index face : {f, g}) ++first_[face];
    for (std::size_t f = 0; f < growth_.size(); ++f) first_[f + 1] += first_[f];           // where each ends, until it is filled
    pairs_of_face_.resize(2 * pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;)
      for (const Index face : {pairs_[i].first, pairs_[i].second}) pairs_of_face_[--first_[face]] = i;
    slot_.assign(growth_.size(), -1);
    Index number = 0;
    for (std::size_t f = 0; f < slot_.size(); ++f)
      if (first_[f + 1] > first_[f]) slot_[f] = number++;
    facets_.resize(number);
  }

  // The one that bulges more, if it alone would have to be flat, or the other one, or both, where patches cross, though the faces do not.
  void append_bulging(Index f, Index g, std::vector<Index>& bulging)
  {
    if (growth_[f] < growth_[g]) std::swap(f, g);
    if (!(growth_[f] > 0) || !do_cross(facets(f), facets(g)) || cross_each_other(surface_, f, g)) return;
    const bool is_f_enough = !do_cross(flat_facets(f), facets(g)), is_g_enough = !do_cross(facets(f), flat_facets(g));
    if (is_f_enough || !is_g_enough) bulging.push_back(f);
    if (!is_f_enough) bulging.push_back(g);
  }

  Facets flat_facets(Index f) const
  {
    const auto& v = surface_.face_record(f).vertex;
    Facets result;
    for (int k = 0; k < 3; ++k) {
      result.points[TRIANGLES[0][k]] = surface_.position(v[k]);
      result.box += surface_.position(v[k]);
    }
    result.triangles = 1;
    return result;
  }

  const Facets& facets(Index f)
  {
    Facets& result = facets_[slot_[f]];
    if (result.triangles > 0) return result;
    if (!(growth_[f] > 0)) return result = flat_facets(f);
    const auto& v = surface_.face_record(f).vertex;
    const Vector3 &p = surface_.position(v[0]), &q = surface_.position(v[1]), &r = surface_.position(v[2]);
    std::size_t n = 0;
    for (int i = 0; i <= 3; ++i)
      for (int j = 0; i + j <= 3; ++j) {
        const double b = i / 3., c = j / 3., a = 1 - b - c;
        const Vector3 flat = a * p + b * q + c * r;
        result.points[n] = flat + BULGE * (patches_.point(f, {a, b, c}) - flat);
        result.box += result.points[n++];
      }
    result.triangles = 9;
    return result;
  }

  static bool do_cross(const Facets& a, const Facets& b)
  {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    if (!do_overlap(a.box, b.box)) return false;
    const auto box = [](const Facets& x, int i) {
      return Bounding_box(x.points[TRIANGLES[i][0]], x.points[TRIANGLES[i][1]], x.points[TRIANGLES[i][2]]); };
    const auto triangle = [](const Facets& x, int i) {
      const auto corner = [&](int k) {
        const Vector3& p = x.points[TRIANGLES[i][k]];
        return Kernel::Point_3(p.x, p.y, p.z);
      };
      return Kernel::Triangle_3(corner(0), corner(1), corner(2));
    };
    for (int i = 0; i < a.triangles; ++i) {
      const Bounding_box box_of_a = box(a, i);
      if (!do_overlap(box_of_a, b.box)) continue;
      for (int j = 0; j < b.triangles; ++j) {
        if (!do_overlap(box_of_a, box(b, j))) continue;
        const Kernel::Triangle_3 s = triangle(a, i), t = triangle(b, j);
        if (!s.is_degenerate() && !t.is_degenerate() && CGAL::do_intersect(s, t)) return true;
      }
    }
    return false;
  }

  const Patches& patches_;
  const Surface& surface_;
  std::vector<double> growth_;                   // by face: how far its patch may lie beyond its box
  std::vector<std::pair<Index, Index>> pairs_;
  std::vector<std::size_t> first_, pairs_of_face_;       // where the numbers of the pairs of each face begin, and these
  std::vector<Index> slot_;                      // by face: where its facets are; -1: it is in no pair
  std::vector<Facets> facets_;
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_CLOSE_PATCHES_H
