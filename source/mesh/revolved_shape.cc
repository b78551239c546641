// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_sector.h>
#include <ringmotor/mesh/check_section.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/revolved_body.h>
#include <ringmotor/mesh/shapes.h>
#include <ringmotor/mesh/shell_line.h>

#include <algorithm>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** What a revolved body tells of itself; @p Shape is that of the stator or the rotor. */
    template <typename Shape>
    class RevolvedShape : public Shape
    {
    public:
      RevolvedShape(const BodyOrigin &origin, RevolvedBody revolved)
          : Shape(origin), body(std::move(revolved))
      {
      }

      bool has_part(const types::material_id part) const override
      {
        return body.section.has_part(part) || (part == ids::lip_shell && touches_with_shell());
      }
      bool has_face(const types::boundary_id name) const override
      {
        return !body.section.edges_named(name).empty() ||
               (name == ids::lip && touches_with_shell());
      }
      ContactLine contact_line() const override { return ringmotor::contact_line(body); }
      bool has_whole_contact() const override
      {
        if (touches_with_shell())
          return true;
        std::vector<Section::Edge> edges;
        for (const types::boundary_id name : {ids::tooth_top, ids::lip})
          for (const Section::Edge &edge : body.section.edges_named(name))
            edges.push_back(edge);
        return is_one_line(edges);
      }
      FaceProfile profile() const override { return body.face; }
      SectorForm form() const override { return SectorForm::half; }

      RadialRange radii_of(const types::material_id part) const override
      {
        std::vector<Point<2>> places;
        for (const Section::Cell &cell : body.section.cells)
          for (const unsigned int corner : cell.corners)
            if (cell.part == part)
              places.push_back(body.section.points[corner]);
        return radii_around(places);
      }

      Meridian meridian() const override
      {
        constexpr unsigned int n_between = 16; // to find what cuts in between
        const Section section            = with_cells_for_shell(body.section, body.shell_thickness);
        Meridian meridian;
        for (const Section::Cell &cell : section.cells)
        {
          meridian.cells.emplace_back();
          for (const unsigned int corner : cell.corners)
            meridian.cells.back().push_back(section.points[corner]);
        }
        for (const auto &[edge, cells] : section.cells_at_edges())
          for (unsigned int i = 0; i <= n_between && cells.size() == 1; ++i)
          {
            const double share = static_cast<double>(i) / n_between;
            meridian.outline.push_back(
                section.points[edge.first] +
                share * (section.points[edge.second] - section.points[edge.first]));
          }
        return meridian;
      }

    protected:
      const RevolvedBody body;

    private:
      bool touches_with_shell() const { return body.section.shell.n_in_contact > 0; }
    };

    class RevolvedStator : public RevolvedShape<StatorShape>
    {
    public:
      using RevolvedShape::RevolvedShape;

      bool has_part(const types::material_id part) const override
      {
        return RevolvedShape::has_part(part) ||
               (part == ids::piezoceramic && body.skin_thickness > 0.);
      }
      bool has_slots() const override { return body.slots.has_teeth(); }
      std::vector<RadialRange> on_felt() const override { return radii_on_felt(body); }
      SectorMesh sector(const unsigned int level, MPI_Comm communicator) const override
      {
        return make_sector(body, SectorForm::half, SectorGrading::level(level), communicator);
      }
      SectorMesh tooth(const unsigned int level, MPI_Comm communicator) const override
      {
        return make_tooth(body, SectorGrading::level(level), communicator);
      }
      SectorMesh contact_tooth(const RadialRange &lip, const InterfaceGrading &grading,
                               MPI_Comm communicator) const override
      {
        return make_contact_tooth(body, lip.inner, lip.outer, grading, communicator);
      }
    };

    class RevolvedRotor : public RevolvedShape<RotorShape>
    {
    public:
      using RevolvedShape::RevolvedShape;

      double bar_stiffness() const override { return body.bar_stiffness; }
      SectorMesh sector(const unsigned int level, MPI_Comm communicator) const override
      {
        return contact_sector(RotorGrading::level(level), {}, communicator);
      }
      SectorMesh contact_sector(const RotorGrading &grading, const InterfaceGrading &lip,
                                MPI_Comm communicator) const override
      {
        return make_rotor_sector(body, SectorForm::half, grading, communicator, lip);
      }
    };
  } // namespace

  std::unique_ptr<const StatorShape> revolved_stator(const Parameters &parameters)
  {
    return std::make_unique<RevolvedStator>(origin_of(parameters, BodyOf::stator),
                                            stator_body(parameters));
  }

  std::unique_ptr<const RotorShape> revolved_rotor(const Parameters &parameters)
  {
    return std::make_unique<RevolvedRotor>(origin_of(parameters, BodyOf::rotor),
                                           rotor_body(parameters));
  }
} // namespace ringmotor
