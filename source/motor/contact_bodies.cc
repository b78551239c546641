// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/surface_compliance.h>
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/motor/contact_bodies.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/surface_load.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** All degrees of freedom of the nodes of a surface of solids. */
    std::vector<SectorNodes::Dof> dofs_of(const ContactSurface &surface)
    {
      std::vector<SectorNodes::Dof> dofs;
      for (const SurfaceNode &node : surface.nodes)
        for (const auto &[dof, coefficient] : node.displacement[0])
          dofs.push_back(dof);
      return dofs;
    }

    SectorMesh tooth_mesh(const Parameters &parameters, const ContactDiscretisation &discretisation,
                          const bool is_clamped)
    {
      SectorMesh mesh = stator_shape(parameters)
                            ->contact_tooth(rotor_shape(parameters)->contact_line().radii,
                                            discretisation.tooth, MPI_COMM_SELF);
      if (is_clamped)
        for (const auto &face : mesh.triangulation->active_face_iterators())
          if (face->at_boundary() && face->boundary_id() == ids::tooth_foot)
            face->set_boundary_id(ids::clamped);
      return mesh;
    }

    std::vector<CondensationSupport> rotor_loads(const CyclicSector &sector)
    {
      const Traction up     = [](const Point<3> &) { return std::array<Complex, 3>{{0., 0., 1.}}; };
      const Traction around = [](const Point<3> &x)
      {
        const double r = std::hypot(x[0], x[1]);
        const Complex i(0., 1.);
        return std::array<Complex, 3>{{-i * x[1] / r, i * x[0] / r, 0.}};
      };
      std::vector<CondensationSupport> supports;
      for (const unsigned int part : {0u, 1u})
      {
        const Vector<double> load =
            sector.from_forces(part == 0 ? face_load(sector, ids::ring_top, up)
                                         : face_load(sector, ids::ring_bore, around))[part];
        supports.push_back({part, {}});
        const double scale = 1. / load.l1_norm();
        for (SectorNodes::Dof dof = 0; dof < load.size(); ++dof)
          if (load[dof] != 0.)
            supports.back().load.emplace_back(dof, scale * load[dof]);
      }
      return supports;
    }
  } // namespace

  ContactDiscretisation ContactDiscretisation::level(const unsigned int level)
  {
    const InterfaceGrading coarse{1, 1}, fine{2, 1}, finer{2, 2}, finest{3, 2};
    static const std::array<ContactDiscretisation, finest_level + 1> levels{
        {{2, coarse, coarse, {0.5, 0.3, 0.6}},
         {2, fine, fine, {0.25, 0.3, 0.6}},
         {3, fine, fine, {0.1, 0.1, 0.8}},
         {3, finer, finer, {0.05, 0.1, 0.8}},
         {3, finest, finest, {0.02, 0.1, 0.8}}}};
    return levels.at(level);
  }

  ToothBody::ToothBody(const Parameters &parameters, const ContactDiscretisation &discretisation,
                       const bool is_clamped)
      : mesh(tooth_mesh(parameters, discretisation, is_clamped)),
        sector(mesh, {{ids::tooth, parameters.materials.stator_metal}}, discretisation.degree),
        top(solid_surface(sector, ids::tooth_top)), whole_top(whole_surface(top, mesh.form)),
        foot(dofs_of(solid_surface(sector, ids::tooth_foot)))
  {
  }

  Condensation ToothBody::condensed(const double angular_frequency, const bool with_interior) const
  {
    return Condensation(sector, displacement_forms(top), foot, {}, std::pow(angular_frequency, 2),
                        with_interior);
  }

  std::vector<std::array<Complex, 3>> ToothBody::top_motion(const WaveMotion &wave,
                                                            const Condensation &condensed) const
  {
    return sector_motion(condensed.prescribed_response(0, foot_motion(wave)), whole_top.origin);
  }

  std::vector<double> ToothBody::foot_motion(const WaveMotion &wave) const
  {
    std::vector<double> motion(2 * foot.size());
    for (unsigned int i = 0; i < foot.size(); ++i)
    {
      const Point<3> &x          = sector.nodes().position(sector.nodes().node(foot[i]));
      const double r             = std::hypot(x[0], x[1]);
      const auto u               = wave(x);
      const Tensor<1, 3> along   = sector.nodes().direction(foot[i]);
      const Complex displacement = u[0] * (along[0] * x[0] + along[1] * x[1]) / r +
                                   u[1] * (along[1] * x[0] - along[0] * x[1]) / r + u[2] * along[2];
      motion[i]               = displacement.real();
      motion[foot.size() + i] = displacement.imag();
    }
    return motion;
  }

  std::vector<double> on_surface(const CyclicSector &sector,
                                 const std::vector<LinearForm> &displacements, const Mode &mode)
  {
    std::vector<double> values;
    for (const Vector<double> &field : sector.in_axes(mode.motion))
      for (const LinearForm &form : displacements)
      {
        values.push_back(0.);
        for (const auto &[dof, coefficient] : form)
          values.back() += coefficient * field[dof];
      }
    return values;
  }

  RotorBody::RotorBody(const Parameters &parameters, const ContactDiscretisation &discretisation)
      : mesh(rotor_shape(parameters)
                 ->contact_sector(discretisation.rotor, discretisation.lip, MPI_COMM_SELF)),
        sector(mesh, material_table(parameters.materials, Body::rotor), discretisation.degree),
        lip(mesh.sections.count(ids::lip_shell) > 0 ? shell_surface(sector, ids::lip_shell)
                                                    : solid_surface(sector, ids::lip)),
        whole_lip(whole_surface(lip, mesh.form)),
        has_bars(mesh.foundations.count(ids::radial_bars) > 0)
  {
  }

  Condensation RotorBody::condensed(const bool with_interior) const
  {
    return Condensation(sector, displacement_forms(lip), {}, rotor_loads(sector), 0.,
                        with_interior);
  }

  std::vector<unsigned int> RotorBody::held(const unsigned int k) const
  {
    if (k > 1)
      return {};
    return k == 1 && has_bars ? std::vector<unsigned int>{0} : std::vector<unsigned int>{0, 1};
  }

  double RotorBody::inertia(const Condensation &condensation, const unsigned int k,
                            const unsigned int support) const
  {
    const std::vector<unsigned int> held = this->held(k);
    CondensationLoad unit;
    for (const unsigned int each : held)
      unit.supports.push_back(each == support ? 1. : 0.);
    const SectorMotion motion = condensation.interior(k, held, {unit}).front();
    return motion_products(sector, {&motion}).front().mass;
  }
} // namespace ringmotor
