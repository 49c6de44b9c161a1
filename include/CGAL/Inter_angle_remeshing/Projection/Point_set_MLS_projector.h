// Copyright (c) 2026 The Inter_angle_remeshing authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_PROJECTION_POINT_SET_MLS_PROJECTOR_H
#define CGAL_INTER_ANGLE_REMESHING_PROJECTION_POINT_SET_MLS_PROJECTOR_H

#include <CGAL/Inter_angle_remeshing/internal/arguments/refuse.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Sample_tree.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/Vector3.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/power_of_two_unit.h>
#include <CGAL/Inter_angle_remeshing/internal/geometry/to_vector3.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Inter_angle_remeshing {

/*!
\ingroup PkgInterAngleRemeshingProjection

@brief projects onto the moving least squares surface of a point set with normals, by the procedure of Alexa et al.

For each query r the k nearest points are taken whose normals look the same way as that of the nearest one. A reference
plane with the normal n through q = r + t n is sought that minimizes Σ <n, p_i - q>² θ(|p_i - q|) with
θ(d) = exp(-d² / h²), by turns for n (an eigenvector of the weighted covariance) and for t. Then a polynomial in two
variables is fitted to the heights of the points over that plane with the same weights; the projection is the point of
its graph over q.

With the points of `Upsampled_point_set` this is the projection of Zheng and Lv. `MLS_projector` is nearer to a smooth
surface, keeps sharp edges, and takes a fraction of the time; this class also serves where there is a scan and no mesh.
It rounds sharp edges off. A projection that would lie further than 2 h from the nearest point, or whose fit fails, is the
projection onto the tangent plane of the nearest point instead.

All queries are const and may run concurrently; each takes O(log n + k). `Eigen` is needed.

Source: M. Alexa, J. Behr, D. Cohen-Or, S. Fleishman, D. Levin, C. Silva, <em>Point Set Surfaces</em>, IEEE
Visualization 2001; X. Zheng and Z. Lv, <em>Isotropic Remeshing with Inter-Angle Optimization</em>, ICIG 2025.

@tparam Point a point of a \cgal kernel

\cgalModels{RemeshingProjector}
*/
template <class Point>
class Point_set_MLS_projector
{
  using Vector3 = internal::Vector3;

public:
  /// a point
  using Point_3 = Point;

  /// copies a point set and builds a `Kd_tree` on it, in time O(n log n).
  /// @tparam PointWithNormalRange a model of `ConstRange` of pairs of a point and a vector, the unit normal: an
  ///         `Upsampled_point_set`, for instance
  /// @param points the points with their normals
  /// @param k the number of neighbors that a fit takes, at least 6
  /// @param degree the total degree of the polynomial, from 0 to 4; it falls where there are too few neighbors
  /// @param bandwidth h, in the units of the points; 0: for each query, the root of the mean squared distance of its
  ///        neighbors from it
  /// @throws CGAL::Precondition_exception if there is no point, if a coordinate is not finite, if `k` is under 6, `degree`
  ///         over 4, or `bandwidth` negative or not finite
  template <class PointWithNormalRange>
  explicit Point_set_MLS_projector(const PointWithNormalRange& points, unsigned k = 20, unsigned degree = 2,
                                   double bandwidth = 0)
    : data_(std::make_shared<const Data>(points)), k_(k), degree_(degree), bandwidth_(bandwidth)
  {
    if (k < 6) internal::refuse(CALLER, "k is " + std::to_string(k) + "; it must be at least 6");
    if (degree > 4) internal::refuse(CALLER, "the degree is " + std::to_string(degree) + "; it must be at most 4");
    if (!(bandwidth >= 0) || !std::isfinite(bandwidth))
      internal::refuse(CALLER, "the bandwidth is " + internal::to_text(bandwidth) + "; it must be finite and not negative");
  }

  /// returns the projection of `p`.
  Point_3 project(const Point_3& p) const
  {
    const Vector3 r = data_->unit * projection(internal::to_vector3(p, data_->unit));
    return Point_3(r.x, r.y, r.z);
  }

  /// returns `project(p)`.
  Point_3 operator()(const Point_3& p) const { return project(p); }

private:
  static constexpr const char* CALLER = "Point_set_MLS_projector::Point_set_MLS_projector()";
  static constexpr int MAXIMUM_PLANE_STEPS = 20;
  static constexpr double PLANE_TOLERANCE = 1e-6;      // of q, in bandwidths
  static constexpr double LARGEST_DISTANCE = 2;        // from the nearest point, in bandwidths

  struct Data
  {
    template <class PointWithNormalRange>
    explicit Data(const PointWithNormalRange& range) : Data(split(range)) {}

    struct Split { std::vector<Vector3> points, normals; };
    explicit Data(Split&& s)
      : unit(unit_of(s.points)), points(in_units(unit, std::move(s.points))), normals(std::move(s.normals)), tree(points)
    {}

    template <class PointWithNormalRange>
    static Split split(const PointWithNormalRange& range)
    {
      Split s;
      for (const auto& entry : range) {
        s.points.push_back(internal::to_vector3(entry.first));
        s.normals.push_back(internal::to_vector3(entry.second));
        if (!internal::is_finite(s.points.back()) || !internal::is_finite(s.normals.back()))
          internal::refuse(CALLER, "point number " + std::to_string(s.points.size() - 1) +
                                   " has a coordinate that is not finite");
      }
      if (s.points.empty()) internal::refuse(CALLER, "there is no point");
      return s;
    }

    static double unit_of(const std::vector<Vector3>& points)
    {
      double extent = 0;
      for (const Vector3& p : points) extent = internal::larger_extent(extent, p - points.front());
      return internal::power_of_two_unit(extent);
    }
    static std::vector<Vector3> in_units(double unit, std::vector<Vector3> points)
    {
      for (Vector3& p : points) p = (1 / unit) * p;
      return points;
    }

    double unit;                         // of the points, a power of two
    std::vector<Vector3> points, normals;
    internal::Sample_tree tree;
  };

  struct Plane { Vector3 origin, normal; };

  Vector3 projection(const Vector3& r) const
  {
    std::vector<std::size_t> found = data_->tree.nearest(r, k_);
    const Vector3 nearest = data_->points[found.front()], its_normal = data_->normals[found.front()];
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](std::size_t i) { return !(dot(data_->normals[i], its_normal) > 0); }), found.end());
    const Vector3 onto_tangent_plane = r - dot(r - nearest, its_normal) * its_normal;
    double h = bandwidth_ / data_->unit;
    if (!(h > 0)) {
      for (const std::size_t i : found) h += squared_distance(data_->points[i], r) / double(found.size());
      h = std::sqrt(h);
    }
    if (found.size() < 3 || !(h > 0)) return onto_tangent_plane;
    const Plane plane = reference_plane(r, found, its_normal, h);
    const Vector3 result = plane.origin + height(plane, found, h) * plane.normal;
    const double bound = LARGEST_DISTANCE * h;
    return internal::is_finite(result) && squared_distance(result, nearest) <= bound * bound ? result
                                                                                            : onto_tangent_plane;
  }

  static double weight(const Vector3& p, const Vector3& q, double h)
  {
    return std::exp(-squared_distance(p, q) / (h * h));
  }

  Plane reference_plane(const Vector3& r, const std::vector<std::size_t>& neighbors, const Vector3& start,
                        double h) const
  {
    Plane plane{r, start};
    for (int step = 0; step < MAXIMUM_PLANE_STEPS; ++step) {
      Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
      Vector3 sum;
      double total = 0;
      for (const std::size_t i : neighbors) {
        const Vector3 d = data_->points[i] - plane.origin;
        const double w = weight(data_->points[i], plane.origin, h);
        const Eigen::Vector3d e(d.x, d.y, d.z);
        covariance += w * e * e.transpose();
        sum += w * d;
        total += w;
      }
      if (!(total > 0)) break;
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
      solver.computeDirect(covariance);
      const Eigen::Vector3d n = solver.eigenvectors().col(0);
      plane.normal = {n[0], n[1], n[2]};
      if (dot(plane.normal, start) < 0) plane.normal = -1. * plane.normal;
      // On the line through r: as far as the weighted mean of the points lies from the plane.
      const Vector3 mean = plane.origin + (1 / total) * sum;
      const Vector3 origin = r + dot(mean - r, plane.normal) * plane.normal;
      const double moved = squared_distance(origin, plane.origin);
      plane.origin = origin;
      if (moved <= PLANE_TOLERANCE * PLANE_TOLERANCE * h * h) break;
    }
    return plane;
  }

  // The constant of the polynomial that is fitted to the heights over the plane.
  double height(const Plane& plane, const std::vector<std::size_t>& neighbors, double h) const
  {
    const auto size_of = [](unsigned degree) { return (degree + 1) * (degree + 2) / 2; };
    unsigned degree = degree_;
    while (degree > 0 && size_of(degree) > neighbors.size()) --degree;
    const Eigen::Index n = Eigen::Index(size_of(degree));
    Vector3 u, v;
    internal::complete_frame(plane.normal, u, v);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n), row(n);
    for (const std::size_t i : neighbors) {
      const Vector3 d = (1 / h) * (data_->points[i] - plane.origin);
      const double x = dot(d, u), y = dot(d, v), w = std::exp(-squared_length(d));
      Eigen::Index column = 0;
      for (unsigned sum = 0; sum <= degree; ++sum)
        for (unsigned power = 0; power <= sum; ++power) row[column++] = std::pow(x, sum - power) * std::pow(y, power);
      a += w * row * row.transpose();
      b += w * dot(d, plane.normal) * row;
    }
    constexpr double RIDGE = 1e-9;       // keeps points on a line solvable
    a.diagonal().array() += RIDGE * a(0, 0);
    return h * a.ldlt().solve(b)[0];
  }

  std::shared_ptr<const Data> data_;     // shared by copies of the projector
  unsigned k_, degree_;
  double bandwidth_;
};

} // namespace Inter_angle_remeshing
} // namespace CGAL

#endif // CGAL_INTER_ANGLE_REMESHING_PROJECTION_POINT_SET_MLS_PROJECTOR_H
