// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_RELAX_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_RELAX_PASS_H

#include <CGAL/Inter_angle_remeshing/Recipe.h>
#include <CGAL/Inter_angle_remeshing/internal/Move_rule.h>
#include <CGAL/Inter_angle_remeshing/internal/curves/Input_curves.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/thin_angles.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Sweep_data.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/parallel_blocks.h>
#include <CGAL/Inter_angle_remeshing/internal/sizing/grading.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// Moves vertices tangentially towards the centre of their neighbors and pulls them back onto the surface (Zheng and
// Lv, relocation): p' = p + λ (I - n nᵀ)(centre - p). Sweeps run in place (Gauss-Seidel) with λ > 1. Vertices on curves slide
// along them, by the part of that step that leads there.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

// How flat a star is: ρ = |Σ c| / Σ |c| over the cross products c of its faces, 1 in a plane. Under the first bound
// a vertex, the tip of a spike, stays; from the second on it takes the whole step.
constexpr double RHO_FIXED = 0.6, RHO_FREE = 0.85;
// Where spikes are those of noise, more than this, see noise(), the bounds fall, down to so small a part.
constexpr double LITTLE_NOISE = 0.02, LEAST_BOUND = 0.2;
// Stars less flat than this take guarded steps.
constexpr double RHO_GUARDED = 0.9;
// Sweeps for which normals hold; dampings hold for a pass.
constexpr unsigned SWEEPS_A_NORMAL = 4;
// Smallest cosine between the normals of a face before and after a step: 60 degrees.
constexpr double STEP_NORMAL_COSINE = 0.5;
// A step that turns a face too far is tried again by half and by a quarter.
constexpr int STEP_TRIALS = 3;
// A tangential step that is shorter than this fraction of the altitude of the star's smallest face, over a link edge
// of the length that it has in an equilateral triangle of the star's mean area, turns no face. In terms of the faces'
// cross products c, the square of the altitude is |c_min|² / (2/√3 mean |c|). Where the longest link edge is more than so many times as
// long as that, it takes its place; and sooner where long edges are protected: around these the next stars have long link edges, too, and
// take guarded steps, as theirs is not safe any more once others around them have moved.
constexpr double SAFE_STEP = 0.75, LONG_LINK_EDGE = 5, LONG_LINK_EDGE_BESIDE_PROTECTED = 1.5;
// λ of a slide, and the largest part of the way to the next vertex of the curve that it takes.
constexpr double SLIDE_RELAXATION = 1.3, LONGEST_SLIDE = 0.6;
// Steps that have to be tested are not worth it when they are shorter than this part of a safe step, or of the way to the nearer
// vertex on the curve.
constexpr double NEGLIGIBLE_STEP = 0.045, NEGLIGIBLE_SLIDE = 0.03;

// When vertices are pulled back onto the surface; guarded steps always are.
enum class Pull_back { never, after_last_sweep };

// Whether a face with the cross product `after` looks more along the normal than one with `before`.
inline bool turns_towards(const Vector3& before, const Vector3& after, const Vector3& normal)
{
  const double old_part = dot(before, normal), new_part = dot(after, normal);
  return new_part > 0 && new_part * length(before) > old_part * length(after);
}

// Functions of the innermost loop are inlined by force: some compilers would rather not, which costs 5% of a run.
class Relaxation
{
public:
  using Index = Sweep_data::Index;

  Relaxation(const Recipe& recipe, const Input_curves& curves, const Grading& grading, const Move_rule& move_rule, double noise,
             bool has_long_protected_edges, bool keeps_long_edges)
    : recipe_(recipe), curves_(curves), grading_(grading), move_rule_(move_rule),
      bound_(noise > LITTLE_NOISE ? (std::max)(LEAST_BOUND, LITTLE_NOISE / noise) : 1.),
      has_long_protected_edges_(has_long_protected_edges), keeps_angles_(keeps_long_edges),
      thin_(keeps_long_edges ? THIN_SQUARED_SINE_OF_KEPT_EDGES : THIN_SQUARED_SINE)
  {}

  // Returns the number of vertices that may have moved: all of them, or those of a region. Slides leave no chord further than
  // `curve_tolerance` from its curve, unless it is that already.
  template <class ConcurrencyTag>
  std::size_t run(Remeshing_mesh& mesh, const Projection& projector, unsigned sweeps, Pull_back pull_back,
                  double curve_tolerance, const Sweep_data::Region* region = nullptr);

private:
  using Mobility = Sweep_data::Mobility;

  // The star of a vertex: the sum of its faces' cross products, the sum of their squared lengths, the smallest one of
  // these, the squared length of the longest link edge, and the step to the centre.
  struct Star
  {
    Vector3 cross;
    double sum_of_squares = 0;
    double smallest_square = std::numeric_limits<double>::infinity();
    double longest_link_square = 0;
    Vector3 to_centre;
  };

  Star star(std::size_t i) const;
  template <int VALENCE>
  Star star_of(std::size_t i, int valence) const;
  double rho(std::size_t i, const Star& star, double length_of_cross) const;
  Vector3 to_centre(std::size_t i) const;
  Vector3 to_uniform_centre(std::size_t i) const;
  Vector3 to_weighted_centre(std::size_t i) const;

  double damping(double rho) const
  {
    return (std::min)(1., (std::max)(0., (rho - bound_ * RHO_FIXED) / (bound_ * (RHO_FREE - RHO_FIXED))));
  }

  Vector3 refresh(std::size_t i);
  Vector3 refresh_normal(std::size_t i);
  void sweep(std::size_t begin, std::size_t end, unsigned number, const Projection& projector);
  bool may_move(std::size_t i, const Vector3& q) const { return move_rule_(*mesh_, data_.order[i], data_.position[i], q); }
  bool turns_face(std::size_t i, const Vector3& before, const Vector3& after) const;
  bool turns_no_face(std::size_t i, const Vector3& q) const;
  bool keeps_faces(std::size_t i, const Vector3& q, bool is_safe) const;
  double smallest_angle(std::size_t i, const Vector3& p) const;
  void take_step(std::size_t i, const Vector3& step, bool keeps_angles);
  void take_guarded_step(std::size_t i, const Vector3& step, const Projection& projector);
  void slide(std::size_t i);
  double chord_deviation(std::size_t i, double shift, const Vector3& p) const;
  template <class ConcurrencyTag>
  void project_all(const Projection& projector);

  const Recipe& recipe_;
  const Input_curves& curves_;
  const Grading& grading_;
  const Move_rule& move_rule_;
  const double bound_;                // of ρ, as part of that of a clean mesh
  const bool has_long_protected_edges_;
  const bool keeps_angles_;           // of all stars, not only of those at curves and beside them
  const double thin_;                 // squared sine of the angle under which none of these is made smaller
  Remeshing_mesh* mesh_ = nullptr;    // of the run: keeps the places on curves
  double curve_tolerance_ = 0;
  Sweep_data data_;
  std::vector<Vector3> normal_;       // unit
  std::vector<double> step_factor_;   // λ times damping; negative: guarded
  std::vector<double> safe_step_;     // squared length of a step that need not be tested
};

template <int VALENCE>
Relaxation::Star Relaxation::star_of(std::size_t i, int valence) const
{
  const int n = VALENCE > 0 ? VALENCE : valence;
  const Index* ring = data_.ring(i);
  const Vector3& p = data_.position[i];
  Star result;
  Vector3 sum;
  Vector3 previous = data_.position[ring[n - 1]] - p;
  for (int k = 0; k < n; ++k) {
    const Vector3 current = data_.position[ring[k]] - p;
    const Vector3 c = cross(previous, current);
    const double square = squared_length(c);
    result.cross += c;
    result.sum_of_squares += square;
    result.smallest_square = (std::min)(result.smallest_square, square);
    result.longest_link_square = (std::max)(result.longest_link_square, squared_distance(previous, current));
    sum += current;
    previous = current;
  }
  result.to_centre = (1. / n) * sum;
  return result;
}

// Most vertices are regular: their loop is unrolled.
inline Relaxation::Star Relaxation::star(std::size_t i) const
{
  const int valence = data_.valence(i);
  Star result = valence == 6 ? star_of<6>(i, 6) : star_of<0>(i, valence);
  if (recipe_.weights != Recipe::Weights::uniform) result.to_centre = to_weighted_centre(i);
  return result;
}

BOOST_FORCEINLINE Vector3 Relaxation::to_centre(std::size_t i) const
{
  return recipe_.weights == Recipe::Weights::uniform ? to_uniform_centre(i) : to_weighted_centre(i);
}

BOOST_FORCEINLINE Vector3 Relaxation::to_uniform_centre(std::size_t i) const
{
  const int n = data_.valence(i);
  const Index* r = data_.ring(i);
  const std::vector<Vector3>& x = data_.position;
  if (n == 6)
    return (1. / 6) * ((x[r[0]] + x[r[1]]) + (x[r[2]] + x[r[3]]) + (x[r[4]] + x[r[5]])) - x[i];
  Vector3 sum;
  for (int k = 0; k < n; ++k) sum += x[r[k]];
  return (1. / n) * sum - x[i];
}

inline Vector3 Relaxation::to_weighted_centre(std::size_t i) const
{
  const int n = data_.valence(i);
  const Index* r = data_.ring(i);
  const Vector3& p = data_.position[i];
  Vector3 sum;
  double total = 0;
  for (int k = 0; k < n; ++k) {
    const Vector3 &before = data_.position[r[(k + n - 1) % n]], &q = data_.position[r[k]],
                  &after = data_.position[r[(k + 1) % n]];
    double weight;
    if (recipe_.weights == Recipe::Weights::area)
      weight = length(triangle_cross(p, before, q)) + length(triangle_cross(p, q, after));
    else {
      const auto cotangent = [](const Vector3& apex, const Vector3& a, const Vector3& b) {
        const double doubled_area = length(triangle_cross(apex, a, b));
        return doubled_area > 0 ? dot(a - apex, b - apex) / doubled_area : 0.;
      };
      weight = (std::max)(0., cotangent(before, p, q) + cotangent(after, p, q));
    }
    sum += weight * (q - p);
    total += weight;
  }
  return total > 0 ? (1 / total) * sum : Vector3();
}

// Takes normal, damping and safe step of vertex i from its star as it is; returns the step to the centre.
inline Vector3 Relaxation::refresh(std::size_t i)
{
  const Star s = star(i);
  const double l = length(s.cross);
  if (!(l > 0)) {
    normal_[i] = Vector3();
    step_factor_[i] = safe_step_[i] = 0;
    return {};
  }
  const double flatness = rho(i, s, l);
  normal_[i] = (1 / l) * s.cross;
  step_factor_[i] = recipe_.relaxation * damping(flatness);
  const double link_square = l * (2 / std::sqrt(3.)) / data_.valence(i);
  const double bound = has_long_protected_edges_ ? LONG_LINK_EDGE_BESIDE_PROTECTED : LONG_LINK_EDGE;
  const bool has_long_link = s.longest_link_square > bound * bound * link_square;
  if (flatness < RHO_GUARDED || data_.mobility[i] == Mobility::guarded || (has_long_link && has_long_protected_edges_) ||
      move_rule_.is_given())
    step_factor_[i] = -step_factor_[i];
  safe_step_[i] = SAFE_STEP * SAFE_STEP * flatness * s.smallest_square / (has_long_link ? s.longest_link_square : link_square);
  return s.to_centre;
}

// ρ, or a lower bound of it that says enough: Σ |c| ≤ √(n Σ c²), with one root for all the faces.
inline double Relaxation::rho(std::size_t i, const Star& star, double length_of_cross) const
{
  const int n = data_.valence(i);
  const double bound = length_of_cross / std::sqrt(n * star.sum_of_squares);
  if (bound >= RHO_GUARDED) return bound;
  const Index* ring = data_.ring(i);
  double sum = 0;
  for (int k = 0; k < n; ++k)
    sum += length(triangle_cross(data_.position[i], data_.position[ring[k]], data_.position[ring[(k + 1) % n]]));
  return length_of_cross / sum;
}

// Takes the normal of vertex i alone from its star as it is; returns the step to the centre. In a hexagon the sum of
// the six cross products is that of three, over every other neighbor.
BOOST_FORCEINLINE Vector3 Relaxation::refresh_normal(std::size_t i)
{
  const int n = data_.valence(i);
  const Index* r = data_.ring(i);
  const std::vector<Vector3>& x = data_.position;
  const Vector3 p = x[i];
  Vector3 sum;
  if (n == 6)
    sum = cross(x[r[0]] - p, x[r[1]] - x[r[5]]) + cross(x[r[2]] - p, x[r[3]] - x[r[1]]) +
          cross(x[r[4]] - p, x[r[5]] - x[r[3]]);
  else
    for (int k = 0; k < n; ++k) sum += cross(x[r[k]] - p, x[r[(k + 1) % n]] - p);
  const double l = length(sum);
  normal_[i] = l > 0 ? (1 / l) * sum : Vector3();
  return to_centre(i);
}

inline void Relaxation::sweep(std::size_t begin, std::size_t end, unsigned number, const Projection& projector)
{
  const bool is_first = number == 0, takes_normals = number % SWEEPS_A_NORMAL == 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (data_.mobility[i] == Mobility::fixed) continue;
    if (data_.is_sliding(i)) { slide(i); continue; }
    const Vector3 step = is_first || std::signbit(step_factor_[i]) ? refresh(i)
                         : takes_normals ? refresh_normal(i) : to_centre(i);
    const Vector3 tangential = step - dot(step, normal_[i]) * normal_[i];
    if (std::signbit(step_factor_[i])) take_guarded_step(i, -step_factor_[i] * tangential, projector);
    else take_step(i, step_factor_[i] * tangential, keeps_angles_);
  }
}

// Whether no face around vertex i turns by more than 60 degrees when the vertex moves to q, unless it turns towards
// the normal of the star: a face that lies on its back, or a needle whose normal means little, may. A sliding vertex has
// no such normal.
inline bool Relaxation::turns_face(std::size_t i, const Vector3& before, const Vector3& after) const
{
  return !is_cosine_at_least(before, after, STEP_NORMAL_COSINE) && !turns_towards(before, after, normal_[i]);
}

inline bool Relaxation::turns_no_face(std::size_t i, const Vector3& q) const
{
  const Vector3& p = data_.position[i];
  return data_.all_of_link(i, [&](Index u, Index v) {
    const Vector3 &a = data_.position[u], &b = data_.position[v];
    return !turns_face(i, triangle_cross(p, a, b), triangle_cross(q, a, b));
  });
}

// Whether none of the faces around vertex i, where angles are kept, turns when the vertex moves to q, which a safe step does not make
// them do, nor grows thin.
inline bool Relaxation::keeps_faces(std::size_t i, const Vector3& q, bool is_safe) const
{
  const Vector3& p = data_.position[i];
  double thinnest = thin_;
  const bool turns_none = data_.all_of_link(i, [&](Index u, Index v) {
    const Vector3 &a = data_.position[u], &b = data_.position[v];
    const Vector3 after = triangle_cross(q, a, b);
    if (!is_safe && turns_face(i, triangle_cross(p, a, b), after)) return false;
    const double x = squared_distance(q, a), y = squared_distance(a, b), z = squared_distance(b, q),
                 longest = (std::max)({x * y, y * z, z * x}), area = squared_length(after);
    if (area < thinnest * longest) thinnest = area / longest;
    return true;
  });
  return turns_none && (thinnest == thin_ || !is_thinner(thinnest, smallest_angle(i, p)));
}

// The squared sine of the smallest angle of the faces around vertex i if it lay at p.
inline double Relaxation::smallest_angle(std::size_t i, const Vector3& p) const
{
  double smallest = 1;
  data_.all_of_link(i, [&](Index u, Index v) {
    smallest = (std::min)(smallest, squared_sine_of_smallest_angle(p, data_.position[u], data_.position[v]));
    return true;
  });
  return smallest;
}

BOOST_FORCEINLINE void Relaxation::take_step(std::size_t i, const Vector3& step, bool keeps_angles)
{
  const bool is_safe = squared_length(step) <= safe_step_[i];
  double factor = 1;
  for (int trial = 0; trial < STEP_TRIALS; ++trial, factor /= 2) {
    const Vector3 q = data_.position[i] + factor * step;
    if (!(keeps_angles ? keeps_faces(i, q, is_safe) : is_safe || turns_no_face(i, q)) || !may_move(i, q)) continue;
    data_.position[i] = q;
    return;
  }
}

// Projects at once.
inline void Relaxation::take_guarded_step(std::size_t i, const Vector3& step, const Projection& projector)
{
  if (squared_length(step) < NEGLIGIBLE_STEP * NEGLIGIBLE_STEP * safe_step_[i]) return;
  double factor = 1;
  for (int trial = 0; trial < STEP_TRIALS; ++trial, factor /= 2) {
    Index hint = data_.hint[i];
    const Vector3 q = projector(data_.position[i] + factor * step, hint);
    if (!projector.is_compatible(hint, normal_[i])) continue;
    const bool is_safe = squared_distance(q, data_.position[i]) <= safe_step_[i];
    if (!(keeps_angles_ || data_.mobility[i] == Mobility::guarded ? keeps_faces(i, q, is_safe) : is_safe || turns_no_face(i, q)) ||
        !may_move(i, q))
      continue;
    data_.position[i] = q;
    data_.hint[i] = hint;
    return;
  }
}

// How far the curve is from the two chords at sliding vertex i if it lay at p, which is `shift` further on the curve.
inline double Relaxation::chord_deviation(std::size_t i, double shift, const Vector3& p) const
{
  double largest = 0;
  const Sweep_data::Slide& slide = data_.slide(i);
  for (const int k : {0, 1}) {
    const Index end = slide.ends[k];
    largest = (std::max)(largest, curves_.deviation(mesh_->curve_of(end), mesh_->arc_length(end) + shift,
                                                    mesh_->arc_length(end ^ 1), p, data_.position[slide.neighbors[k]]));
  }
  return largest;
}

// Moves vertex i along its curve, towards the centre of its neighbors.
inline void Relaxation::slide(std::size_t i)
{
  const auto& [ends, neighbors] = data_.slide(i);
  const Index curve = mesh_->curve_of(ends[0]);
  const double t = mesh_->arc_length(ends[0]);
  double low = mesh_->arc_length(ends[0] ^ 1) - t, high = mesh_->arc_length(ends[1] ^ 1) - mesh_->arc_length(ends[1]);
  const bool is_reversed = low > high;
  if (is_reversed) std::swap(low, high);
  if (!(low < 0 && high > 0)) return;
  normal_[i] = Vector3();
  const Vector3& p = data_.position[i];
  const Vector3 along = data_.position[neighbors[is_reversed ? 0 : 1]] - data_.position[neighbors[is_reversed ? 1 : 0]];
  const double l = length(along);
  if (!(l > 0)) return;
  const double wanted = SLIDE_RELAXATION * dot(to_uniform_centre(i), along) / l;
  double shift = (std::min)(LONGEST_SLIDE * high, (std::max)(LONGEST_SLIDE * low, wanted));
  if (std::abs(shift) < NEGLIGIBLE_SLIDE * (std::min)(-low, high)) return;
  for (int trial = 0; trial < STEP_TRIALS; ++trial, shift /= 2) {
    const Vector3 q = curves_.point(curve, t + shift);
    if (!keeps_faces(i, q, false)) continue;
    const double deviation = chord_deviation(i, shift, q);
    if (deviation > curve_tolerance_ * grading_.field_part(data_.order[i]) && deviation > chord_deviation(i, 0, p)) continue;
    if (!may_move(i, q)) continue;
    data_.position[i] = q;
    for (const Index end : ends) mesh_->arc_length(end) += shift;
    return;
  }
}

// A vertex whose projection would turn a face goes a part of the way, and the rest as its neighbors make room. One
// whose projection would lead onto another sheet stays where it is until the next time.
template <class ConcurrencyTag>
void Relaxation::project_all(const Projection& projector)
{
  data_.for_each_coloured_block<ConcurrencyTag>(projector.is_concurrent, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (data_.mobility[i] == Mobility::fixed || data_.is_sliding(i)) continue;
      Index hint = data_.hint[i];
      const Vector3 q = projector(data_.position[i], hint);
      if (!projector.is_compatible(hint, normal_[i])) continue;
      data_.hint[i] = hint;
      take_step(i, q - data_.position[i], false);
    }
  });
}

template <class ConcurrencyTag>
std::size_t Relaxation::run(Remeshing_mesh& mesh, const Projection& projector, unsigned sweeps, Pull_back pull_back,
                            double curve_tolerance, const Sweep_data::Region* region)
{
  mesh_ = &mesh;
  curve_tolerance_ = curve_tolerance;
  data_.read<ConcurrencyTag>(mesh, region);
  normal_.resize(data_.size());
  step_factor_.resize(data_.size());
  safe_step_.resize(data_.size());
  if (sweeps == 0)
    for (std::size_t i = 0; i < data_.size(); ++i)
      if (data_.mobility[i] != Mobility::fixed && !data_.is_sliding(i)) refresh(i);
  for (unsigned s = 0; s < sweeps; ++s) {
    data_.for_each_coloured_block<ConcurrencyTag>(projector.is_concurrent, [&](std::size_t begin, std::size_t end) {
      sweep(begin, end, s, projector);
    });
  }
  if (pull_back != Pull_back::never) project_all<ConcurrencyTag>(projector);
  data_.write(mesh);
  return data_.number_of_movable();
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_RELAX_PASS_H
