// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/structure/mirror.h>
#include <ringmotor/wave/tooth_motion.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;
    using Cell    = DoFHandler<3>::active_cell_iterator;

    struct Face
    {
      Cell cell;
      unsigned int number;
    };

    /** A point of the mesh with its angle. */
    struct Candidate
    {
      Cell cell;
      Point<3> unit, position;
      double theta;
    };

    double radius(const Point<3> &x)
    {
      return std::hypot(x[0], x[1]);
    }

    std::vector<Face> tooth_top(const CyclicSector &sector)
    {
      std::vector<Face> faces;
      for (const auto &cell : sector.dofs().active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face) && cell->face(face)->boundary_id() == ids::tooth_top)
            faces.push_back({cell, face});
      return faces;
    }

    std::vector<Face> tooth_foot(const CyclicSector &sector)
    {
      std::vector<Face> faces;
      for (const auto &cell : sector.dofs().active_cell_iterators())
        if (cell->material_id() == ids::tooth)
          for (const unsigned int face : cell->face_indices())
            if (!cell->at_boundary(face) && cell->neighbor(face)->material_id() == ids::base)
              faces.push_back({cell, face});
      return faces;
    }

    /** The points at radius @p r on the edges of @p faces. */
    std::vector<Candidate> on_edges(const CyclicSector &sector, const std::vector<Face> &faces,
                                    const double r)
    {
      const double tolerance = places::rounding * r;
      std::vector<Candidate> candidates;
      for (const Face &face : faces)
        for (unsigned int line = 0; line < 4; ++line)
        {
          const unsigned int cell_line = GeometryInfo<3>::face_to_cell_lines(face.number, line);
          const Point<3> start         = GeometryInfo<3>::unit_cell_vertex(
                      GeometryInfo<3>::line_to_cell_vertices(cell_line, 0));
          const Point<3> end = GeometryInfo<3>::unit_cell_vertex(
              GeometryInfo<3>::line_to_cell_vertices(cell_line, 1));
          const auto unit     = [&](const double t) { return start + t * (end - start); };
          const auto position = [&](const double t)
          { return sector.geometry().transform_unit_to_real_cell(face.cell, unit(t)); };
          const auto excess = [&](const double t) { return radius(position(t)) - r; };
          const auto add    = [&](const double t)
          {
            const Point<3> x = position(t);
            candidates.push_back({face.cell, unit(t), x, std::atan2(x[1], x[0])});
          };
          const double at_start = excess(0.), at_end = excess(1.);
          if (std::abs(at_start) < tolerance)
            add(0.);
          if (std::abs(at_end) < tolerance)
            add(1.);
          if (std::min(at_start, at_end) < -tolerance && std::max(at_start, at_end) > tolerance)
          {
            std::uintmax_t iterations = 60;
            const auto bracket        = boost::math::tools::toms748_solve(
                       excess, 0., 1., at_start, at_end, boost::math::tools::eps_tolerance<double>(48),
                       iterations);
            add(0.5 * (bracket.first + bracket.second));
          }
        }
      return candidates;
    }

    /** The point of @p faces at theta = 0 and radius @p r; its height is near @p z. */
    Candidate at_center(const CyclicSector &sector, const std::vector<Face> &faces, const double r,
                        const double z)
    {
      Candidate best{faces[0].cell, Point<3>(), Point<3>(), 0.};
      double least = std::numeric_limits<double>::max();
      for (const Face &face : faces)
        try
        {
          const unsigned int across = GeometryInfo<3>::unit_normal_direction[face.number];
          Point<3> position(r, 0., z), unit;
          for (unsigned int step = 0; step < 5; ++step) // the foot need not be level
          {
            unit         = sector.geometry().transform_real_to_unit_cell(face.cell, position);
            unit[across] = face.number % 2;
            position[2]  = sector.geometry().transform_unit_to_real_cell(face.cell, unit)[2];
          }
          const double outside = GeometryInfo<3>::distance_to_unit_cell(unit);
          if (outside < least)
          {
            least = outside;
            best  = {face.cell, GeometryInfo<3>::project_to_unit_cell(unit), position, 0.};
          }
        }
        catch (const Mapping<3>::ExcTransformationFailed &)
        {
          // far from this cell
        }
      // Of the size of the cell; arcs of wide cells are not exact between their nodes.
      AssertThrow(least < 1e-2, ExcMessage("The tooth has no point at its centre."));
      return best;
    }

    void add_points(const CyclicSector &sector, const std::vector<Face> &faces,
                    const std::string &level, std::vector<ToothPoint> &points)
    {
      double inner = std::numeric_limits<double>::max(), outer = 0.;
      for (const Face &face : faces)
        for (const unsigned int vertex : face.cell->face(face.number)->vertex_indices())
        {
          inner = std::min(inner, radius(face.cell->face(face.number)->vertex(vertex)));
          outer = std::max(outer, radius(face.cell->face(face.number)->vertex(vertex)));
        }
      const bool half = sector.sector_mesh().form == SectorForm::half;
      const std::array<std::pair<const char *, double>, 3> radii{
          {{"inner", inner}, {"mid", 0.5 * (inner + outer)}, {"outer", outer}}};
      for (const auto &[place, r] : radii)
      {
        const std::vector<Candidate> edges = on_edges(sector, faces, r);
        AssertThrow(!edges.empty(), ExcInternalError());
        const auto [low, high] =
            std::minmax_element(edges.begin(), edges.end(),
                                [](const auto &a, const auto &b) { return a.theta < b.theta; });
        const Candidate center = at_center(sector, faces, r, high->position[2]);
        const std::string name = level + "_" + place;
        if (half)
          points.push_back({name + "_L", mirrored(high->position), high->cell, high->unit, true});
        else
          points.push_back({name + "_L", low->position, low->cell, low->unit, false});
        points.push_back({name + "_C", center.position, center.cell, center.unit, false});
        points.push_back({name + "_R", high->position, high->cell, high->unit, false});
      }
    }

    /** In (-pi, pi], with rounding at -pi counted as pi and rounding at 0 as 0. */
    double principal(const double angle)
    {
      const double turned = std::remainder(angle, 2. * numbers::PI);
      return turned < -numbers::PI + 1e-9 ? turned + 2. * numbers::PI : turned;
    }
  } // namespace

  std::vector<ToothPoint> tooth_points(const CyclicSector &sector)
  {
    std::vector<ToothPoint> points;
    const std::vector<Face> top = tooth_top(sector), foot = tooth_foot(sector);
    if (top.empty())
      return points;
    AssertThrow(!foot.empty(), ExcMessage("The tooth has no foot."));
    add_points(sector, top, "top", points);
    add_points(sector, foot, "foot", points);
    return points;
  }

  std::array<Complex, 3> displacement_at(const ToothPoint &point, const ComplexField &field)
  {
    const FiniteElement<3> &fe = point.cell->get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    point.cell->get_dof_indices(dofs);
    std::array<Complex, 3> value{};
    for (unsigned int i = 0; i < dofs.size(); ++i)
      value[fe.system_to_component_index(i).first] +=
          fe.shape_value(i, point.unit) * Complex(field.real[dofs[i]], field.imaginary[dofs[i]]);
    return point.mirrored ? mirrored(value) : value;
  }

  EllipticMotion elliptic_motion(const ToothPoint &point, const Mode &mode)
  {
    const std::array<Complex, 3> u = displacement_at(point, mode.motion.solid);
    const double r                 = radius(point.position);
    const double cosine = point.position[0] / r, sine = point.position[1] / r;
    const Complex wave =
        std::polar(1., mode.nodal_diameter * std::atan2(point.position[1], point.position[0]));
    const Complex radial = wave * (cosine * u[0] + sine * u[1]);
    // w_t = -u_theta = A_t sin(omega t - n theta - phi) is Re(-i A_t exp(i(omega t - n theta -
    // phi))).
    const Complex along_sine = wave * (cosine * u[1] - sine * u[0]) / Complex(0., 1.);
    const Complex normal     = wave * u[2];
    return {std::abs(normal),
            std::abs(along_sine),
            std::abs(radial),
            principal(-std::arg(normal)),
            principal(std::arg(normal) - std::arg(along_sine)),
            principal(-std::arg(radial))};
  }

  void normalise_to_amplitude(Mode &mode, const std::vector<ToothPoint> &points,
                              const double amplitude)
  {
    const auto outer =
        std::find_if(points.begin(), points.end(),
                     [](const ToothPoint &point) { return point.name == "top_outer_C"; });
    mode.motion *= amplitude / displacement_at(*outer, mode.motion.solid)[2];
  }
} // namespace ringmotor
