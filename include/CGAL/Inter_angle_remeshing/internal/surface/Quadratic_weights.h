// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_QUADRATIC_WEIGHTS_H
#define CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_QUADRATIC_WEIGHTS_H

#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/solve_by_cholesky.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// The value of a smooth function at a point of a face as a sum of its values at vertices around, exact where it is quadratic in the plane.
//
// At p = Σ λ_i x_i such a function is f(p) = Σ λ_i (f(x_i) + ½ ∇f(x_i)·(p − x_i)): with H the matrix of its second derivatives and
// d_i = p − x_i, f(x_i) = f(p) − ∇f(p)·d_i + ½ d_iᵀ H d_i and ∇f(x_i) = ∇f(p) − H d_i, so that a summand is λ_i (f(p) − ½ ∇f(p)·d_i),
// and Σ λ_i d_i = 0. The gradient at a vertex is that of the quadratic polynomial in its tangent plane through its value that is the
// nearest to the values around it.

namespace CGAL {
namespace Inter_angle_remeshing {
namespace internal {

template <class TriangleMesh, class VertexPointMap>
class Quadratic_weights
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  // A quadratic polynomial without its constant has five coefficients; one value more levels out what is wrong in the others.
  static constexpr std::size_t LEAST_NEIGHBORS = 6;
  // More neighbors are those of the hub of a fan of needles.
  static constexpr std::size_t MOST_NEIGHBORS = 50;
  // Faces around a vertex whose normals turn by more than that from its own, 60 degrees, are no smooth surface.
  static constexpr double LEAST_COSINE = 0.5;
  // Values around a vertex count for no more than so many times theirs: an even star's for up to 4/3.
  static constexpr double LARGEST_GAIN = 4;

public:
  Quadratic_weights(const TriangleMesh& tmesh, VertexPointMap vpm) : tmesh_(tmesh), vpm_(vpm) {}

  // The weights at the point of a face with these barycentric coordinates: linear ones where the surface is not smooth.
  const std::vector<std::pair<vertex_descriptor, double>>& at(const std::array<vertex_descriptor, 3>& corners,
                                                              const std::array<double, 3>& coordinates)
  {
    std::array<Vector3, 3> x;
    for (int i = 0; i < 3; ++i) x[i] = internal::to_vector3(get(vpm_, corners[i]));
    set_unit(x[1] - x[0], x[2] - x[0]);
    weights_.clear();
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Vector3 offset = coordinates[j] * (inverse_unit_ * (x[j] - x[i])) + coordinates[k] * (inverse_unit_ * (x[k] - x[i]));
      if (!add_gradient(corners[i], x[i], offset, coordinates[i] / 2)) {
        weights_.clear();
        break;
      }
    }
    for (int i = 0; i < 3; ++i) weights_.emplace_back(corners[i], coordinates[i]);
    return weights_;
  }

private:
  // Adds what values around v weigh in `factor` times their gradient at v, x, times the offset.
  bool add_gradient(vertex_descriptor v, const Vector3& x, const Vector3& offset, double factor)
  {
    Vector3 normal;
    if (factor == 0) return true;
    if (!find_neighbors(v, x, normal)) return false;
    Vector3 s, t;
    complete_frame(normal, s, t);
    std::array<std::array<double, 5>, 5> a{};
    rows_.clear();
    for (const Vector3& e : offsets_) {
      const double u = dot(e, s), w = dot(e, t), weight = 1 / (u * u + w * w);
      if (!std::isfinite(weight)) return false;
      const std::array<double, 5> row{u, w, u * u, u * w, w * w};
      for (int i = 0; i < 5; ++i)
        for (int j = 0; j <= i; ++j) a[i][j] += weight * row[i] * row[j];
      rows_.push_back({row, weight});
    }
    std::array<double, 5> direction{dot(offset, s), dot(offset, t), 0, 0, 0};
    if (!solve_by_cholesky(a, direction)) return false;
    double gain = 0, sum = 0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      double c = 0;
      for (int i = 0; i < 5; ++i) c += rows_[k].first[i] * direction[i];
      c *= rows_[k].second;
      gain += std::abs(c);
      sum += factor * c;
      weights_.emplace_back(neighbors_[k], factor * c);
    }
    if (!(gain <= LARGEST_GAIN)) return false;
    weights_.emplace_back(v, -sum);
    return true;
  }

  // The vertices around v, x, with their offsets from it, and further ones around these where they are few. False where the surface
  // is not smooth there, or they are too many.
  bool find_neighbors(vertex_descriptor v, const Vector3& x, Vector3& normal)
  {
    neighbors_.clear();
    offsets_.clear();
    crosses_.clear();
    normal = Vector3();
    for (const halfedge_descriptor h : CGAL::halfedges_around_target(v, tmesh_)) {
      if (neighbors_.size() == MOST_NEIGHBORS) return false;
      add_neighbor(source(h, tmesh_), x);
      if (CGAL::is_border(h, tmesh_)) continue;
      crosses_.push_back(cross(offset_of(target(next(h, tmesh_), tmesh_), x), offsets_.back()));
      normal += crosses_.back();
    }
    if (!(squared_length(normal) > 0)) return false;
    normal = unit(normal);
    for (const Vector3& c : crosses_)
      if (!is_cosine_at_least(c, normal, LEAST_COSINE)) return false;
    const std::size_t n = neighbors_.size();
    if (n < LEAST_NEIGHBORS)
      for (std::size_t i = 0; i < n; ++i)
        for (const vertex_descriptor w : CGAL::vertices_around_target(neighbors_[i], tmesh_)) {
          if (w == v || std::find(neighbors_.begin(), neighbors_.end(), w) != neighbors_.end()) continue;
          if (neighbors_.size() == MOST_NEIGHBORS) return false;
          add_neighbor(w, x);
        }
    return true;
  }

  void add_neighbor(vertex_descriptor w, const Vector3& x)
  {
    neighbors_.push_back(w);
    offsets_.push_back(offset_of(w, x));
  }

  Vector3 offset_of(vertex_descriptor w, const Vector3& x) const { return inverse_unit_ * (internal::to_vector3(get(vpm_, w)) - x); }

  // Lengths are measured by those of a face with these edges, so that no square of one leaves the range of numbers.
  void set_unit(const Vector3& a, const Vector3& b)
  {
    inverse_unit_ = 1 / (std::max)({std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(b.x), std::abs(b.y), std::abs(b.z)});
  }

  const TriangleMesh& tmesh_;
  VertexPointMap vpm_;
  double inverse_unit_ = 1;                          // of length
  std::vector<std::pair<vertex_descriptor, double>> weights_;
  std::vector<vertex_descriptor> neighbors_;         // of the vertex at hand
  std::vector<Vector3> offsets_;                     // of these
  std::vector<Vector3> crosses_;                     // of the faces around it: normals, of twice their areas
  std::vector<std::pair<std::array<double, 5>, double>> rows_;   // of the least squares, with their weights
};

} // namespace internal
} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_INTERNAL_SURFACE_QUADRATIC_WEIGHTS_H
