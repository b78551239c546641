// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/check_parts.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/places.h>
#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/mesh/sector_cuts.h>
#include <ringmotor/mesh/shapes.h>
#include <ringmotor/parameters/parameters.h>

#include <algorithm>
#include <array>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Face = Triangulation<3>::face_iterator;

    /** (r, z) of a place (r, theta, z). */
    Point<2> meridional(const Point<3> &place)
    {
      return Point<2>(place[0], place[2]);
    }

    std::vector<Point<2>> corners_of(const Face &face)
    {
      std::vector<Point<2>> corners;
      for (unsigned int i = 0; i < 4; ++i)
        corners.push_back(meridional(cylindrical(face->vertex(i))));
      return corners;
    }

    double turn(const Point<2> &from, const Point<2> &over, const Point<2> &to)
    {
      const Tensor<1, 2> a = over - from, b = to - over;
      return a[0] * b[1] - a[1] * b[0];
    }

    /** The corners of the convex hull, counterclockwise. */
    std::vector<Point<2>> hull_of(std::vector<Point<2>> points)
    {
      const auto before = [](const Point<2> &a, const Point<2> &b)
      { return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1]; };
      std::sort(points.begin(), points.end(), before);
      std::vector<Point<2>> hull;
      for (const unsigned int half : {0, 1}) // below, from left to right, and back above
      {
        const std::size_t begin = half == 0 ? 0 : hull.size();
        for (const Point<2> &x : points)
        {
          while (hull.size() >= begin + 2 && turn(hull.end()[-2], hull.back(), x) <= 0.)
            hull.pop_back();
          hull.push_back(x);
        }
        hull.pop_back(); // the first one of the other half
        std::reverse(points.begin(), points.end());
      }
      return hull;
    }

    /** m^2, of a face, for the angles of its corners. */
    double area_of(const Face &face, const double radius)
    {
      std::array<Tensor<1, 3>, 4> corner;
      for (unsigned int i = 0; i < 4; ++i)
      {
        corner[i] = cylindrical(face->vertex(i));
        corner[i][1] *= radius;
      }
      return 0.5 * cross_product_3d(corner[3] - corner[0], corner[2] - corner[1]).norm();
    }

    bool have_line_in_common(const Face &one, const Face &other)
    {
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 4; ++j)
          if (one->line_index(i) == other->line_index(j))
            return true;
      return false;
    }

    /** What the mesh of a file tells of its body; @p Shape is that of the stator or the rotor. */
    template <typename Shape>
    class ReadShape : public Shape
    {
    public:
      ReadShape(const BodyOrigin &origin, const Parameters &parameters, const BodyOf of)
          : Shape(origin), mesh(read_sector(origin.file, parameters.motor.n_teeth, MPI_COMM_SELF,
                                            of, parameters.modes.domain))
      {
      }

      bool has_part(const types::material_id part) const override
      {
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          if (cell->material_id() == part)
            return true;
        return false;
      }

      bool has_face(const types::boundary_id name) const override { return !faces(name).empty(); }
      FaceProfile profile() const override { return {}; }
      SectorForm form() const override { return mesh.form; }

      ContactLine contact_line() const override
      {
        std::vector<Point<2>> places;
        for (const types::boundary_id name : {ids::tooth_top, ids::lip})
          for (const Face &face : faces(name))
          {
            const std::vector<Point<2>> corners = corners_of(face);
            places.insert(places.end(), corners.begin(), corners.end());
          }
        return contact_line_through(places);
      }

      bool has_whole_contact() const override
      {
        std::vector<Face> waiting, unreached;
        for (const types::boundary_id name : {ids::tooth_top, ids::lip})
          for (const Face &face : faces(name))
            (waiting.empty() ? waiting : unreached).push_back(face);
        while (!waiting.empty())
        {
          const Face reached = waiting.back();
          waiting.pop_back();
          const auto neighbours =
              std::partition(unreached.begin(), unreached.end(),
                             [&](const Face &face) { return !have_line_in_common(face, reached); });
          waiting.insert(waiting.end(), neighbours, unreached.end());
          unreached.erase(neighbours, unreached.end());
        }
        return unreached.empty();
      }

      RadialRange radii_of(const types::material_id part) const override
      {
        std::vector<Point<2>> places;
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          for (const unsigned int i : cell->vertex_indices())
            if (cell->material_id() == part)
              places.push_back(meridional(cylindrical(cell->vertex(i))));
        return radii_around(places);
      }

      Meridian meridian() const override
      {
        constexpr unsigned int n_between = 4; // of the cells' edges, which are short
        Meridian meridian;
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
        {
          std::vector<Point<2>> corners;
          for (const unsigned int i : cell->vertex_indices())
            corners.push_back(meridional(cylindrical(cell->vertex(i))));
          meridian.cells.push_back(hull_of(corners));
          for (const auto &face : cell->face_iterators())
            for (unsigned int i = 0;
                 i < 4 && face->at_boundary() && !ids::is_plane(face->boundary_id()); ++i)
            {
              const Point<2> from = meridional(cylindrical(face->line(i)->vertex(0))),
                             to   = meridional(cylindrical(face->line(i)->vertex(1)));
              for (unsigned int j = 0; j <= n_between; ++j)
                meridian.outline.push_back(from + static_cast<double>(j) / n_between * (to - from));
            }
        }
        return meridian;
      }

      SectorMesh sector(const unsigned int level, MPI_Comm communicator) const override
      {
        SectorMesh copy = copy_of(mesh, communicator);
        copy.triangulation->refine_global(level);
        return copy;
      }

    protected:
      std::vector<Face> faces(const types::boundary_id name) const
      {
        std::vector<Face> found;
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == name)
              found.push_back(face);
        return found;
      }

      SectorMesh mesh;
    };

    class ReadStator : public ReadShape<StatorShape>
    {
    public:
      using ReadShape::ReadShape;

      bool has_slots() const override
      {
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (cell->material_id() == ids::tooth && face->at_boundary() &&
                ids::is_cut(face->boundary_id()))
              return false;
        return true;
      }

      std::vector<RadialRange> on_felt() const override
      {
        std::vector<RadialRange> ranges;
        for (const Face &face : faces(ids::bottom))
          ranges.push_back(radii_around(corners_of(face)));
        return joined(ranges);
      }

      SectorMesh tooth(const unsigned int level, MPI_Comm communicator) const override
      {
        SectorMesh tooth = tooth_of(mesh, communicator);
        for (const auto &face : tooth.triangulation->active_face_iterators())
          if (face->at_boundary() && face->boundary_id() == ids::tooth_foot)
            face->set_boundary_id(ids::clamped);
        tooth.triangulation->refine_global(level);
        return tooth;
      }

      SectorMesh contact_tooth(const RadialRange &lip, const InterfaceGrading &grading,
                               MPI_Comm communicator) const override
      {
        SectorMesh tooth = tooth_of(mesh, communicator);
        limit_contact(tooth, ids::tooth_top, lip);
        cut_at_contact(tooth, ids::tooth_top, grading, AroundContact::towards_side);
        return tooth;
      }
    };

    class ReadRotor : public ReadShape<RotorShape>
    {
    public:
      explicit ReadRotor(const Parameters &parameters)
          : ReadShape(origin_of(parameters, BodyOf::rotor), parameters, BodyOf::rotor),
            stiffness_of_bars(ringmotor::bar_stiffness(parameters, origin, height_of_bars()))
      {
        if (stiffness_of_bars > 0.)
          mesh.foundations[ids::radial_bars] = stiffness_of_bars;
      }

      double bar_stiffness() const override { return stiffness_of_bars; }

      SectorMesh contact_sector(const RotorGrading &grading, const InterfaceGrading &lip,
                                MPI_Comm communicator) const override
      {
        SectorMesh copy = copy_of(mesh, communicator);
        cut_at_reentrant_edges(copy, grading.first / RotorGrading::level(0).first, grading.ratio);
        cut_at_contact(copy, ids::lip, lip, AroundContact::evenly);
        return copy;
      }

    private:
      /** m, of a band around the ring with the area of the faces that bars hold; 0 without. */
      double height_of_bars() const
      {
        double area = 0., moment = 0.;
        for (const Face &face : faces(ids::radial_bars))
        {
          const double radius = mean_place_of_corners(face)[0], of_face = area_of(face, radius);
          area += of_face;
          moment += radius * of_face;
        }
        const double angle =
            (mesh.form == SectorForm::half ? 1. : 2.) * numbers::PI / mesh.n_sectors;
        return area > 0. ? area / (moment / area * angle) : 0.;
      }

      const double stiffness_of_bars; ///< N/m^3
    };
  } // namespace

  std::unique_ptr<const StatorShape> read_stator(const Parameters &parameters)
  {
    auto stator = std::make_unique<ReadStator>(origin_of(parameters, BodyOf::stator), parameters,
                                               BodyOf::stator);
    check_materials(parameters, stator->origin,
                    [&](const types::material_id part) { return stator->has_part(part); });
    check_felt(parameters, stator->origin, stator->has_face(ids::bottom));
    if (parameters.modes.body == Body::tooth && !stator->has_slots())
      stator->origin.refuse("its tooth (physical id 2) reaches the cut",
                            "Modes/Body = tooth needs slots; allowed: stator");
    return stator;
  }

  std::unique_ptr<const RotorShape> read_rotor(const Parameters &parameters)
  {
    auto rotor = std::make_unique<ReadRotor>(parameters);
    check_materials(parameters, rotor->origin,
                    [&](const types::material_id part) { return rotor->has_part(part); });
    return rotor;
  }
} // namespace ringmotor
