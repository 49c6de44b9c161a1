// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_POLISH_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_POLISH_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/arc_cosine.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/Angle_descent.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/flip_pass.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// Moves vertices along the surface, and those on curves along these, until the angles around them lie within a band, as far
// as that is possible, see Angle_descent.h. What then is still bad beside a curve is flipped away, if a flip helps.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

class Polisher
{
  using Index = Remeshing_mesh::Index;

  // Rounds over the vertices at hand, and how often one on a curve or beside it is looked at; what is not mended by then is
  // stuck, which beside curves is common.
  static constexpr int MAXIMUM_ROUNDS = 30, MAXIMUM_VISITS_AT_CURVES = 12;
  // Flips mend faces at curves that have a smaller angle, or one that is as far over 60 degrees as half of the rest is under.
  static constexpr double POOR_ANGLE = 35;
  static constexpr int FLIP_ROUNDS = 3;

public:
  explicit Polisher(Remeshing_context& context)
    : context_(context), mesh_(context.mesh), descent_(context)
  {}

  // Returns the number of moves and flips.
  std::size_t run()
  {
    is_queued_.assign(mesh_.number_of_vertex_slots(), 0);
    visits_.assign(mesh_.number_of_vertex_slots(), 0);
    queue_bad_faces();
    std::size_t changes = move_queued();
    for (int round = 0; round < FLIP_ROUNDS && mesh_.has_curves(); ++round) {
      const std::size_t flips = flip_beside_curves();
      if (flips == 0) break;
      changes += flips + move_queued();
    }
    return changes;
  }

private:
  std::size_t move_queued()
  {
    std::size_t moves = 0;
    for (int round = 0; round < MAXIMUM_ROUNDS && !queue_.empty(); ++round) {
      std::vector<Index> current;
      current.swap(queue_);
      for (const Index v : current) {
        is_queued_[v] = 0;
        visits_[v] += is_at_curve(v);
      }
      for (const Index v : current) {
        const double left = descent_.step(v);
        if (!(left < 1)) continue;
        ++moves;
        queue(v);
        if (left <= Angle_descent::MUCH_LESS) mesh_.for_each_neighbor(v, [&](Index u) { queue(u); });
      }
    }
    return moves;
  }

  bool is_at_curve(Index v) const
  {
    if (!mesh_.has_curves()) return false;
    bool result = mesh_.is_on_curve(v);
    mesh_.for_each_neighbor(v, [&](Index u) { result = result || mesh_.is_on_curve(u); });
    return result;
  }

  void queue(Index v)
  {
    if (is_queued_[v] || visits_[v] >= MAXIMUM_VISITS_AT_CURVES || !mesh_.is_movable(v)) return;
    is_queued_[v] = 1;
    queue_.push_back(v);
  }

  void queue_bad_faces()
  {
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f)
      if (mesh_.is_face(f) && !holds_band(mesh_, descent_.bands(), f))
        for (const Index v : mesh_.face_record(f).vertex) queue(v);
  }

  // How far the worst angle of a triangle is from the ends of the scale: its smallest angle, or half of what its largest one
  // leaves, in degrees.
  double worst_angle(Index a, Index b, Index c) const
  {
    const Vector3 &p = mesh_.position(a), &q = mesh_.position(b), &r = mesh_.position(c);
    const double cosines[3] = {corner_cosine(p, q, r), corner_cosine(q, r, p), corner_cosine(r, p, q)};
    const double smallest = arc_cosine_in_degrees(*std::max_element(cosines, cosines + 3)),
                 largest = arc_cosine_in_degrees(*std::min_element(cosines, cosines + 3));
    return (std::min)(smallest, (180 - largest) / 2);
  }

  // Flips edges of poor faces at curves where that makes the worst angle of the two better. Returns the number of flips.
  std::size_t flip_beside_curves()
  {
    std::size_t flips = 0;
    if (context_.flip_rule.is_never()) return flips;
    for (Index f = 0; f < Index(mesh_.number_of_face_slots()); ++f) {
      if (!mesh_.is_face(f)) continue;
      const auto& v = mesh_.face_record(f).vertex;
      if (!mesh_.touches_curve(f) || worst_angle(v[0], v[1], v[2]) > POOR_ANGLE) continue;
      for (Index h = 4 * f; h < 4 * f + 3; ++h)
        if (!mesh_.is_on_curve_edge(h) && improves_worst_angle(h) && is_flip_allowed(context_, h, false)) {
          for (const Index u : {mesh_.origin(h), mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.opposite(h))}) queue(u);
          flip(context_, h);
          ++flips;
          break;
        }
    }
    return flips;
  }

  bool improves_worst_angle(Index h) const
  {
    constexpr double NOTICEABLE = 1;
    const Index o = mesh_.opposite(h), a = mesh_.origin(h), b = mesh_.origin(o), c = mesh_.apex(h), d = mesh_.apex(o);
    return (std::min)(worst_angle(a, d, c), worst_angle(d, b, c)) >
           (std::min)(worst_angle(a, b, c), worst_angle(b, a, d)) + NOTICEABLE;
  }

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  Angle_descent descent_;
  std::vector<char> is_queued_, visits_;
  std::vector<Index> queue_;
};

// Returns the number of moves and flips.
inline std::size_t polish_pass(Remeshing_context& context)
{
  return Polisher(context).run();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_POLISH_PASS_H
