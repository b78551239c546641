// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/condensation/cut_responses.h>
#include <ringmotor/motor/condensed_bodies.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/rotor_modes.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    CondensedTooth condense_tooth(const Parameters &parameters, const MotorModel &model,
                                  const StatorWave &wave,
                                  const ContactDiscretisation &discretisation)
    {
      const ToothBody body(parameters, discretisation);
      const Condensation condensation = body.condensed();
      CondensedTooth tooth;
      tooth.surface = body.whole_top;
      tooth.compliance =
          sector_compliance(InterfaceCompliance(condensation), tooth.surface.origin).at_rest;
      tooth.n_dofs      = body.sector.n_dofs();
      tooth.free_motion = model.teeth_move_with_inertia
                              ? body.top_motion(wave.foot, body.condensed(wave.angular_frequency))
                              : body.top_motion(wave.foot, condensation);
      return tooth;
    }

    /** Removes the tangential compliance of a body and the coupling of normal and tangential
     * components. */
    void leave_normal_compliance(SurfaceCompliance &compliance)
    {
      for (unsigned int i = 0; i < compliance.at_rest.m(); ++i)
      {
        for (unsigned int j = 0; j < compliance.at_rest.n(); ++j)
          if (i % 3 != 0 || j % 3 != 0)
            compliance.at_rest(i, j) = 0.;
        for (unsigned int shape = 0; i % 3 != 0 && shape < compliance.shapes.n(); ++shape)
          compliance.shapes(i, shape) = 0.;
      }
    }

    CondensedRotor condense_rotor(const Parameters &parameters, const MotorModel &model,
                                  const ContactSurface &tooth_top,
                                  const ContactDiscretisation &discretisation)
    {
      const unsigned int n_teeth = parameters.motor.n_teeth;
      const double pitch         = 2. * numbers::PI / n_teeth;
      const RotorBody body(parameters, discretisation);
      const SectorSurface &whole = body.whole_lip;

      CondensedRotor rotor;
      rotor.n_dofs = body.sector.n_dofs();
      rotor.mortar = couple(tooth_top, whole.surface, pitch, discretisation.lip_turn);
      if (rotor.mortar.nodes.empty())
        throw UserError("the lip covers no part of the tooth tops; let their faces in contact "
                        "overlap");
      const Condensation condensation = body.condensed(model.rotor_moves_as_whole);
      const InterfaceCompliance interface(condensation);
      SurfaceCompliance of_lip = sector_compliance(interface, whole.origin);
      if (!model.rotor_gives_way_along)
        leave_normal_compliance(of_lip);
      const CutResponses responses(interface, [&](const unsigned int k) { return body.held(k); });
      rotor.compliance                     = RingCompliance(n_teeth, of_lip, rotor.mortar,
                                                            [&](const unsigned int k) { return responses.at(k); });
      const std::vector<unsigned int> held = body.held(1);
      for (const unsigned int support : held)
      {
        const SupportMotion motion = condensation.support_motion(1, held, support);
        // Two halves make a sector, and the mean square of a wave is half of its amplitude's.
        rotor.near_rigid_modes.push_back(
            {at_contact_points(motion.interface, whole.origin, rotor.mortar, pitch),
             n_teeth * motion.stiffness,
             model.rotor_moves_as_whole ? n_teeth * body.inertia(condensation, 1, support) : 0.});
      }
      rotor.mass =
          model.rotor_moves_as_whole ? 2. * n_teeth * body.inertia(condensation, 0, 0) : 0.;
      return rotor;
    }
  } // namespace

  CondensedBodies condense_bodies(const Parameters &parameters, const StatorWave &wave,
                                  const ContactDiscretisation &discretisation)
  {
    const MotorModel model = motor_model(parameters);
    CondensedTooth tooth   = condense_tooth(parameters, model, wave, discretisation);
    CondensedRotor rotor = condense_rotor(parameters, model, tooth.surface.surface, discretisation);
    return {std::move(tooth), std::move(rotor)};
  }

  std::shared_ptr<const CondensedBodies>
  BodiesByMesh::at(const Parameters &parameters, const StatorWave &wave,
                   const ContactDiscretisation &discretisation) const
  {
    const auto condensed = [&]
    {
      return std::make_shared<const CondensedBodies>(
          condense_bodies(parameters, wave, discretisation));
    };
    if (!(discretisation == ContactDiscretisation::level(0)))
      return condensed();
    const MotorModel model = motor_model(parameters);
    auto &bodies           = coarsest[{model.teeth_move_with_inertia, model.rotor_gives_way_along,
                                       model.rotor_moves_as_whole}];
    if (!bodies)
      bodies = condensed();
    return bodies;
  }

  double tooth_inertia_indicator(const Parameters &parameters, const StatorWave &wave)
  {
    const ToothBody body(parameters, ContactDiscretisation::level(0));
    const auto at_once   = body.top_motion(wave.foot, body.condensed()),
               vibrating = body.top_motion(wave.foot, body.condensed(wave.angular_frequency));
    double largest       = 0.;
    for (std::size_t i = 0; i < at_once.size(); ++i)
      largest =
          std::max(largest, std::abs(std::abs(vibrating[i][1]) / std::abs(at_once[i][1]) - 1.));
    return largest;
  }
} // namespace ringmotor
