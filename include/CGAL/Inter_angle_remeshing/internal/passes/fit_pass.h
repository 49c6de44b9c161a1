// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIT_PASS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIT_PASS_H

#include <CGAL/Inter_angle_remeshing/internal/Remeshing_context.h>
#include <CGAL/Inter_angle_remeshing/internal/mesh/Sweep_data.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/angle_bands.h>
#include <CGAL/Inter_angle_remeshing/internal/passes/fit_equations.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/projection.h>
#include <CGAL/Inter_angle_remeshing/internal/surface/surface_walk.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

// Fits the faces, not only the vertices, to the surface: chords of a curved surface lie on one side of it, and least squares
// move them to both sides. Samples of the result look for the nearest point of the surface, and samples of the surface for that
// of the result; with the normal n of the surface, the distance r that a sample is to travel along it, the barycentric
// coordinates b of the sample on its face and its share w of the area, the displacements x of the vertices minimise
//
//   Σ w (n · Σ b_i x_i - r)² + Σ a_i (μ |t_i - c_i|² + NORMAL h_i²),
//
// where t_i and h_i are the parts of x_i in and off the tangent plane, c_i is the tangential way to the centre of the neighbors,
// a_i is a third of the star's area, and μ is `Recipe::fit_tangential_weight`. A few steps of conjugate gradients solve that well
// enough. Vertices on curves stay.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class ConcurrencyTag>
class Surface_fit
{
  using Index = Remeshing_mesh::Index;
  using Barycentric = std::array<double, 3>;

  static constexpr double NORMAL = 0.01;
  static constexpr int STEPS = 2;
  // The longest displacement, in target lengths, and how often one that does harm is halved.
  static constexpr double LONGEST = 0.35;
  static constexpr int TRIALS = 4;
  // Where the surface has more than so many times the faces of the result, one sample stands for each, and further passes pay: the
  // samples cost most of the time, and there is more for the vertices to travel.
  static constexpr std::size_t MANY_FACES = 2;
  static constexpr unsigned FURTHER_PASSES = 2;
  // Samples that are nearer to the surface than this many target lengths, on the average, say that it is flat there: then
  // vertices stay in its plane to the last bit.
  static constexpr double FLAT = 1e-7;
  static constexpr std::size_t BLOCK = 1024, BLOCKS_AT_ONCE = 64;

public:
  explicit Surface_fit(Remeshing_context& context)
    : context_(context), mesh_(context.mesh),
      band_(Angle_bands(context.recipe, LOWER_MARGIN, UPPER_MARGIN).inside)
  {}

  // Does this many passes, further ones where these pay, none where chords are short. Returns the number of vertices moved in the last
  // one.
  std::size_t run(unsigned passes)
  {
    if (context_.is_finer_than_surface()) return 0;
    if (is_much_coarser_than_surface()) passes += FURTHER_PASSES;
    data_.read<ConcurrencyTag>(mesh_);
    equations_.assign(mesh_.number_of_face_slots(), Face_equations());
    nearest_faces_.assign(3 * mesh_.number_of_face_slots(), -1);
    sample_result();
    if (context_.projector.is_input()) sample_surface();
    std::size_t moved = 0;
    for (unsigned pass = 0; pass < passes; ++pass) {
      if (pass > 0) update_equations();
      solve();
      moved = displace();
    }
    data_.write(mesh_);
    return moved;
  }

private:
  bool is_much_coarser_than_surface() const
  {
    return context_.projector.surface->number_of_faces() > MANY_FACES * mesh_.number_of_live_faces();
  }

  static const std::array<Barycentric, 3>& places()
  {
    constexpr double A = 2. / 3, B = 1. / 6;
    static const std::array<Barycentric, 3> result = {{{A, B, B}, {B, A, B}, {B, B, A}}};
    return result;
  }
  Vector3 point_on_face(Index f, const Barycentric& b) const
  {
    const auto& v = mesh_.face_record(f).vertex;
    return b[0] * mesh_.position(v[0]) + b[1] * mesh_.position(v[1]) + b[2] * mesh_.position(v[2]);
  }

  // Where on the surface the walk of a sample begins: where a corner was projected. One on a curve says nothing about the
  // side of the curve; at last the input face is asked that the face descends from.
  Index start(Index f, int k) const
  {
    const auto& v = mesh_.face_record(f).vertex;
    for (int i = 0; i < 3; ++i)
      if (!mesh_.is_on_curve(v[(k + i) % 3])) return mesh_.hint(v[(k + i) % 3]);
    const Index source = context_.projector.face_of(mesh_.face_record(f).source);
    return source >= 0 ? source : mesh_.hint(v[k]);
  }

  // The vectors `x` of the corners of face f.
  std::array<Vector3, 3> corners(const std::vector<Vector3>& x, Index f) const
  {
    const auto& v = mesh_.face_record(f).vertex;
    return {x[data_.rank(v[0])], x[data_.rank(v[1])], x[data_.rank(v[2])]};
  }

  double length_on_face(Index f) const { return context_.length_at(mesh_.face_record(f).vertex[0]); }
  void sample_result();
  void sample_surface();
  void update_equations();
  std::vector<Index> faces_near_surface_faces() const;
  double set_up(std::size_t i);
  void solve();
  std::size_t displace();
  bool keeps_orientation(std::size_t i, const Vector3& p, const Vector3& q) const;
  bool is_in_band(std::size_t i, const Vector3& q) const;
  double energy(std::size_t i, const Vector3& p) const;

  Remeshing_context& context_;
  Remeshing_mesh& mesh_;
  Angle_band band_;                            // what lies out of it, displacements make no worse
  Sweep_data data_;
  std::vector<Face_equations> equations_;      // by face of the mesh
  std::vector<Index> nearest_faces_;           // of the surface, three a face of the mesh
  // By vertex, in the order of `data_`:
  std::vector<Vector3> flat_normal_;           // zero where the surface is not flat
  std::vector<Vector3> displacement_;
  std::vector<Symmetric_matrix> regular_, inverse_;            // what holds it where it is; the inverse of its own block
  std::vector<Vector3> residual_, preconditioned_, direction_; // of the conjugate gradients
};

template <class ConcurrencyTag>
void Surface_fit<ConcurrencyTag>::sample_result()
{
  for_each_block<ConcurrencyTag>(mesh_.number_of_face_slots(), BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (Index f = Index(begin); f < Index(end); ++f) {
      if (!mesh_.is_face(f)) continue;
      const Vector3 c = mesh_.cross_product(f);
      const double area = length(c) / 2;
      if (!(area > 0)) continue;
      for (int k = 0; k < 3; ++k) {
        const Vector3 y = point_on_face(f, places()[k]);
        Index& hint = nearest_faces_[3 * f + k];
        hint = start(f, k);
        const Surface_point s = context_.projector.nearest(y, hint);
        if (squared_distance(s.point, y) > CGAL::square(length_on_face(f)) || !(dot(s.normal, c) > 0)) continue;
        equations_[f].add(places()[k], s.normal, area / 3, dot(s.point - y, s.normal));
      }
    }
  });
}

// For each face of the surface a face of the mesh near by: one of those whose samples it is nearest to, or what a face beside it
// in its patch has. Negative where no sample is.
template <class ConcurrencyTag>
std::vector<Remeshing_mesh::Index> Surface_fit<ConcurrencyTag>::faces_near_surface_faces() const
{
  const Reference_surface& surface = *context_.projector.surface;
  std::vector<Index> result(surface.number_of_faces(), -1), queue;
  const auto seed = [&](Index f, Index g) {
    if (result[f] >= 0) return;
    result[f] = g;
    queue.push_back(f);
  };
  for (std::size_t i = 0; i < nearest_faces_.size(); ++i)
    if (nearest_faces_[i] >= 0) seed(nearest_faces_[i], Index(i / 3));
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (Index h = 4 * queue[i]; h < 4 * queue[i] + 3; ++h)
      if (surface.opposite(h) >= 0 && !is_barrier(surface, h)) seed(surface.face(surface.opposite(h)), result[queue[i]]);
  return result;
}

template <class ConcurrencyTag>
void Surface_fit<ConcurrencyTag>::sample_surface()
{
  struct Sample
  {
    Index face;
    Barycentric place;
    Vector3 normal;
    double weight, r;
  };
  const Projection& projector = context_.projector;
  const Reference_surface& surface = *projector.surface;
  const std::size_t n = is_much_coarser_than_surface() ? 1 : 3;
  const std::vector<Index> first_face = faces_near_surface_faces();
  const double unit = projector.factor;
  const auto sample_faces = [&](std::size_t begin, std::size_t end, const auto& take) {
    for (Index f = Index(begin); f < Index(end); ++f) {
      const double area = length(surface.cross_product(f)) / (2 * unit * unit);
      Index g = first_face[f];
      if (g < 0 || !(area > 0)) continue;
      for (std::size_t k = 0; k < n; ++k) {        // the second begins where the first one ended
        const Barycentric b = n == 1 ? Barycentric{1. / 3, 1. / 3, 1. / 3} : places()[k];
        const Surface_point s = projector.at(f, b);
        const Point_on_triangle c = walk_to_closest_point(mesh_, s.point, g);
        if (squared_distance(c.point, s.point) > CGAL::square(length_on_face(g)) || !(dot(s.normal, mesh_.cross_product(g)) > 0)) continue;
        const auto& v = mesh_.face_record(g).vertex;
        take(Sample{g, barycentric(c, mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])), s.normal,
                    area / double(n), dot(s.point - c.point, s.normal)});
      }
    }
  };
  const auto add = [&](const Sample& s) { equations_[s.face].add(s.place, s.normal, s.weight, s.r); };
  if constexpr (!is_parallel<ConcurrencyTag>())
    sample_faces(0, surface.number_of_faces(), add);
  else {
    // In the same order; some blocks at a time, which need little memory.
    std::vector<std::vector<Sample>> samples(BLOCKS_AT_ONCE);
    for (std::size_t first = 0; first < surface.number_of_faces(); first += BLOCKS_AT_ONCE * BLOCK) {
      const std::size_t count = (std::min)(BLOCKS_AT_ONCE * BLOCK, surface.number_of_faces() - first);
      for_each_block<ConcurrencyTag>(count, BLOCK, [&](std::size_t begin, std::size_t end, std::size_t block) {
        samples[block].clear();
        sample_faces(first + begin, first + end, [&](const Sample& s) { samples[block].push_back(s); });
      });
      for (std::size_t block = 0; block < number_of_blocks(count, BLOCK); ++block)
        for (const Sample& s : samples[block]) add(s);
    }
  }
}

// The vertices have moved: that much less is left for the samples to travel. They are not looked for anew.
template <class ConcurrencyTag>
void Surface_fit<ConcurrencyTag>::update_equations()
{
  for_each_block<ConcurrencyTag>(mesh_.number_of_face_slots(), BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (Index f = Index(begin); f < Index(end); ++f)
      if (mesh_.is_face(f)) equations_[f].subtract(corners(displacement_, f));
  });
  data_.write(mesh_);
}

// The equations of vertex i, from its faces' ones; returns its part of the first residual's square.
template <class ConcurrencyTag>
double Surface_fit<ConcurrencyTag>::set_up(std::size_t i)
{
  const Index v = data_.order[i];
  Vector3 normal, centre;
  double area = 0;
  const double length = context_.length_at(v);
  const double tangential = context_.recipe.fit_tangential_weight;
  Symmetric_matrix own;
  Vector3 right;
  mesh_.for_each_around(v, [&](Index h) {
    const Face_equations& e = equations_[mesh_.face(h)];
    const Vector3 c = mesh_.cross_product(mesh_.face(h));
    normal += c;
    area += internal::length(c) / 6;
    centre += mesh_.position(mesh_.target(h));
    own += e.diagonal(mesh_.corner(h));
    right += e.right(mesh_.corner(h));
  });
  const Vector3 way = (1. / mesh_.valence(v)) * centre - mesh_.position(v), u = unit(normal);
  flat_normal_[i] = squared_length(right) <= CGAL::square(FLAT * length * area) ? u : Vector3();
  regular_[i] = Symmetric_matrix::axial(tangential * area, (NORMAL - tangential) * area, u);
  own += regular_[i];
  inverse_[i] = own.inverse();
  residual_[i] = right + (tangential * area) * (way - dot(way, u) * u);
  direction_[i] = preconditioned_[i] = inverse_[i] * residual_[i];
  return dot(residual_[i], preconditioned_[i]);
}

// Conjugate gradients with the vertices' own blocks as preconditioner. Vertices that do not move have no displacement.
template <class ConcurrencyTag>
void Surface_fit<ConcurrencyTag>::solve()
{
  const std::size_t n = data_.size();
  for (std::vector<Symmetric_matrix>* m : {&regular_, &inverse_}) m->resize(n);
  for (std::vector<Vector3>* x : {&flat_normal_, &residual_, &preconditioned_}) x->resize(n);
  direction_.assign(n, Vector3());
  std::vector<Vector3> image(n);
  std::vector<std::array<Vector3, 3>> products(mesh_.number_of_face_slots());
  std::vector<double> parts(number_of_blocks(n, BLOCK));
  displacement_.assign(n, Vector3());
  // The sum of function(i) over the vertices that move.
  const auto sum_over_vertices = [&](const auto& function) {
    for_each_block<ConcurrencyTag>(n, BLOCK, [&](std::size_t begin, std::size_t end, std::size_t block) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i)
        if (mesh_.is_free(data_.order[i])) sum += function(i);
      parts[block] = sum;
    });
    return std::accumulate(parts.begin(), parts.end(), 0.);
  };

  double rho = sum_over_vertices([&](std::size_t i) { return set_up(i); });
  for (int step = 0; step < STEPS && rho > 0; ++step) {
    for_each_block<ConcurrencyTag>(mesh_.number_of_face_slots(), BLOCK, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (Index f = Index(begin); f < Index(end); ++f)
        if (mesh_.is_face(f)) products[f] = equations_[f] * corners(direction_, f);
    });
    const double curvature = sum_over_vertices([&](std::size_t i) {
      Vector3 sum = regular_[i] * direction_[i];
      mesh_.for_each_around(data_.order[i], [&](Index h) { sum += products[mesh_.face(h)][mesh_.corner(h)]; });
      image[i] = sum;
      return dot(sum, direction_[i]);
    });
    if (!(curvature > 0)) break;
    const double alpha = rho / curvature;
    const double next_rho = sum_over_vertices([&](std::size_t i) {
      displacement_[i] += alpha * direction_[i];
      residual_[i] = residual_[i] - alpha * image[i];
      preconditioned_[i] = inverse_[i] * residual_[i];
      return dot(residual_[i], preconditioned_[i]);
    });
    const double beta = next_rho / rho;
    rho = next_rho;
    sum_over_vertices([&](std::size_t i) { direction_[i] = preconditioned_[i] + beta * direction_[i]; return 0.; });
  }
}

// Whether no face around vertex i turns by more than 26 degrees when it moves from p to q.
template <class ConcurrencyTag>
bool Surface_fit<ConcurrencyTag>::keeps_orientation(std::size_t i, const Vector3& p, const Vector3& q) const
{
  return data_.all_of_link(i, [&](Index u, Index w) {
    const Vector3 &a = data_.position[u], &b = data_.position[w];
    return is_cosine_at_least(triangle_cross(p, a, b), triangle_cross(q, a, b), LITTLE_TURN_COSINE);
  });
}

template <class ConcurrencyTag>
bool Surface_fit<ConcurrencyTag>::is_in_band(std::size_t i, const Vector3& q) const
{
  return data_.all_of_link(i, [&](Index u, Index w) { return band_.holds(q, data_.position[u], data_.position[w]); });
}

// The energy of the angles around vertex i if it lies at p.
template <class ConcurrencyTag>
double Surface_fit<ConcurrencyTag>::energy(std::size_t i, const Vector3& p) const
{
  double sum = 0;
  data_.all_of_link(i, [&](Index u, Index w) {
    const Vector3 &a = data_.position[u], &b = data_.position[w];
    for (const double c : {corner_cosine(p, a, b), corner_cosine(a, b, p), corner_cosine(b, p, a)}) sum += band_.energy(c);
    return true;
  });
  return sum;
}

template <class ConcurrencyTag>
std::size_t Surface_fit<ConcurrencyTag>::displace()
{
  data_.for_each_coloured_block<ConcurrencyTag>(true, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (displacement_[i] == Vector3()) continue;
      const Vector3 p = data_.position[i];
      displacement_[i] = displacement_[i] - dot(displacement_[i], flat_normal_[i]) * flat_normal_[i];
      const double l = length(displacement_[i]), longest = LONGEST * context_.length_at(data_.order[i]);
      if (l > longest) displacement_[i] = (longest / l) * displacement_[i];
      double before = -1;
      const auto raises_energy = [&](const Vector3& q) {
        if (is_in_band(i, q)) return false;
        if (before < 0) before = energy(i, p);
        return energy(i, q) > before;
      };
      const auto may_go = [&](const Vector3& q) {
        return keeps_orientation(i, p, q) && !raises_energy(q) && context_.move_rule(mesh_, data_.order[i], p, q);
      };
      int trial = 0;
      for (; trial < TRIALS && !may_go(p + displacement_[i]); ++trial) displacement_[i] = 0.5 * displacement_[i];
      if (trial == TRIALS) displacement_[i] = Vector3();
      data_.position[i] += displacement_[i];
    }
  });
  return data_.size() - std::size_t(std::count(displacement_.begin(), displacement_.end(), Vector3()));
}

// Returns the number of vertices moved.
template <class ConcurrencyTag>
std::size_t fit_pass(Remeshing_context& context, unsigned passes)
{
  return Surface_fit<ConcurrencyTag>(context).run(passes);
}

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_PASSES_FIT_PASS_H
