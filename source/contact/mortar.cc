// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/mortar.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <map>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** Faces as cells of a triangulation: deal.II then finds points in them. */
    void triangulate(const ContactSurface &surface, const double angle, Triangulation<2> &plane)
    {
      std::vector<Point<2>> vertices;
      std::vector<CellData<2>> cells;
      for (const auto &corners : surface.corners)
      {
        CellData<2> cell;
        for (unsigned int v = 0; v < 4; ++v)
        {
          cell.vertices[v] = vertices.size();
          vertices.emplace_back(corners[v][0], corners[v][1] + angle);
        }
        cells.push_back(cell);
      }
      plane.create_triangulation(vertices, cells, SubCellData());
    }

    using Face = Triangulation<2>::active_cell_iterator;

    using Polygon = std::vector<Point<2>>; ///< counterclockwise

    Polygon outline(const Face &face)
    {
      return {face->vertex(0), face->vertex(1), face->vertex(3), face->vertex(2)};
    }

    /** Twice the area of a triangle, negative if its corners run clockwise. */
    double double_area(const Point<2> &a, const Point<2> &b, const Point<2> &c)
    {
      const Tensor<1, 2> e = b - a, f = c - a;
      return e[0] * f[1] - e[1] * f[0];
    }

    /** The part of a polygon on the left of the line from @p a to @p b. */
    Polygon left_part(const Polygon &polygon, const Point<2> &a, const Point<2> &b)
    {
      Polygon left;
      for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const Point<2> &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double side = double_area(a, b, from), next = double_area(a, b, to);
        if (side >= 0.)
          left.push_back(from);
        if ((side > 0. && next < 0.) || (side < 0. && next > 0.))
          left.push_back(from + side / (side - next) * (to - from));
      }
      return left;
    }

    /** What two convex faces have in common. (Boost's intersection() is only as exact as its
     * integer grid, some 1e-7 of the polygons' size.) */
    Polygon common_part(const Face &a, const Face &b)
    {
      Polygon common     = outline(a);
      const Polygon edge = outline(b);
      for (unsigned int i = 0; i < 4; ++i)
        common = left_part(common, edge[i], edge[(i + 1) % 4]);
      return common;
    }

    bool are_apart(const Face &a, const Face &b)
    {
      const BoundingBox<2> box_a = a->bounding_box(), box_b = b->bounding_box();
      for (unsigned int d = 0; d < 2; ++d)
        if (box_a.lower_bound(d) >= box_b.upper_bound(d) ||
            box_b.lower_bound(d) >= box_a.upper_bound(d))
          return true;
      return false;
    }

    /** Points and weights (m^2, r dr dtheta) on the part that two faces have in common. */
    void segment_points(const Face &a, const Face &b, const Quadrature<2> &of_triangle,
                        std::vector<Point<2>> &points, std::vector<double> &weights)
    {
      const Polygon common = common_part(a, b);
      for (std::size_t i = 1; i + 1 < common.size(); ++i)
      {
        const double area = double_area(common[0], common[i], common[i + 1]);
        if (area <= 1e-15 * a->measure())
          continue;
        for (unsigned int q = 0; q < of_triangle.size(); ++q)
        {
          const Point<2> &unit = of_triangle.point(q);
          points.push_back(common[0] + unit[0] * (common[i] - common[0]) +
                           unit[1] * (common[i + 1] - common[0]));
          weights.push_back(of_triangle.weight(q) * area * points.back()[0]);
        }
      }
    }

    /** The integrals over one face of the tooth. */
    class FaceIntegrals
    {
    public:
      FaceIntegrals(const unsigned int degree)
          : mass(FE_Q<2>(degree).n_dofs_per_cell()), area(mass.m()), element(degree)
      {
      }

      /** Adds a segment shared with a face of the rotor. */
      void add(const Face &tooth, const Face &rotor, const FE_Q<2> &rotor_element,
               const std::vector<std::pair<unsigned int, int>> &rotor_nodes,
               const std::vector<Point<2>> &points, const std::vector<double> &weights)
      {
        const unsigned int n = mass.m(), m = rotor_nodes.size();
        std::vector<double> tooth_shape(n);
        for (unsigned int q = 0; q < points.size(); ++q)
        {
          const Point<2> on_tooth = mapping.transform_real_to_unit_cell(tooth, points[q]),
                         on_rotor = mapping.transform_real_to_unit_cell(rotor, points[q]);
          for (unsigned int i = 0; i < n; ++i)
          {
            tooth_shape[i] = element.shape_value(i, on_tooth);
            area[i] += weights[q] * tooth_shape[i];
          }
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              mass(i, j) += weights[q] * tooth_shape[i] * tooth_shape[j];
          for (unsigned int j = 0; j < m; ++j)
          {
            std::vector<double> &row = mixed[rotor_nodes[j]];
            row.resize(n, 0.);
            const double shape = weights[q] * rotor_element.shape_value(j, on_rotor);
            for (unsigned int i = 0; i < n; ++i)
              row[i] += tooth_shape[i] * shape;
          }
        }
      }

      /** Calls @p visit(node of the face, node of the rotor with its sector, integral of psi times
       * the rotor's shape function). */
      template <typename Visit>
      void for_each_dual_integral(const Visit &visit) const
      {
        // psi = A phi with A = diag(area) mass^-1
        FullMatrix<double> dual = mass;
        dual.gauss_jordan();
        for (const auto &[node, integrals] : mixed)
          for (unsigned int i = 0; i < mass.m(); ++i)
          {
            double sum = 0.;
            for (unsigned int j = 0; j < mass.m(); ++j)
              sum += dual(i, j) * integrals[j];
            visit(i, node, area[i] * sum);
          }
      }

      FullMatrix<double> mass;
      std::vector<double> area; ///< integrals of the tooth's shape functions

    private:
      const FE_Q<2> element;
      const MappingQ<2> mapping{1};
      std::map<std::pair<unsigned int, int>, std::vector<double>> mixed;
    };
    /** Integrals of dual functions times functions of the rotor's nodes, by node and its sector. */
    using DualIntegrals = std::map<std::pair<unsigned int, int>, double>;

    /** From the integrals of all of the tooth's nodes, alone and with the rotor's functions. */
    MortarCoupling coupling_of(const std::vector<double> &area,
                               const std::vector<DualIntegrals> &mixed)
    {
      MortarCoupling coupling;
      const double largest = *std::max_element(area.begin(), area.end());
      for (unsigned int i = 0; i < area.size(); ++i)
      {
        if (area[i] <= -1e-9 * largest)
          throw UserError("the overlap of the rotor with a face of the tooth top is too small for "
                          "quadratic mortar functions; align lines of the mesh of the tooth with "
                          "the edges of the lip (Stator/Mesh file, Rotor/Mesh file)");
        if (area[i] <= 1e-9 * largest)
          continue;
        MortarCoupling::Node node{i, area[i], {}};
        for (const auto &[other, integral] : mixed[i])
          if (std::abs(integral) > 1e-14 * area[i])
            node.weights.push_back({other.first, other.second, integral / area[i]});
        coupling.nodes.push_back(node);
      }
      return coupling;
    }
  } // namespace

  MortarCoupling couple(const ContactSurface &tooth, const ContactSurface &rotor,
                        const double pitch, const double shift)
  {
    Triangulation<2> tooth_plane;
    triangulate(tooth, 0., tooth_plane);
    std::array<Triangulation<2>, 3> rotor_planes;
    for (int sector = -1; sector <= 1; ++sector)
      triangulate(rotor, shift + sector * pitch, rotor_planes[sector + 1]);
    const FE_Q<2> rotor_element(rotor.degree);
    // Exact for products of two shape functions and r on faces that are parallelograms.
    const QDuffy quadrature(tooth.degree + std::max(tooth.degree, rotor.degree) + 2, 1.);

    std::vector<double> area(tooth.nodes.size(), 0.);
    std::vector<DualIntegrals> mixed(tooth.nodes.size());
    for (const Face &face : tooth_plane.active_cell_iterators())
    {
      FaceIntegrals integrals(tooth.degree);
      for (int sector = -1; sector <= 1; ++sector)
        for (const Face &other : rotor_planes[sector + 1].active_cell_iterators())
          if (!are_apart(face, other))
          {
            std::vector<Point<2>> points;
            std::vector<double> weights;
            segment_points(face, other, quadrature, points, weights);
            std::vector<std::pair<unsigned int, int>> nodes;
            for (const unsigned int node : rotor.faces[other->active_cell_index()])
              nodes.emplace_back(node, sector);
            if (!points.empty())
              integrals.add(face, other, rotor_element, nodes, points, weights);
          }
      double covered = 0., whole = 0.;
      for (const double part : integrals.area)
        covered += part;
      whole = face->measure() * face->center()[0];
      if (covered < 1e-6 * whole)
        continue;
      const std::vector<unsigned int> &nodes = tooth.faces[face->active_cell_index()];
      for (unsigned int i = 0; i < nodes.size(); ++i)
        area[nodes[i]] += integrals.area[i];
      integrals.for_each_dual_integral(
          [&](const unsigned int i, const std::pair<unsigned int, int> &node, const double integral)
          { mixed[nodes[i]][node] += integral; });
    }

    return coupling_of(area, mixed);
  }
} // namespace ringmotor
