// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/balance/drive.h>
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/pictures/trace_motion.h>
#include <ringmotor/sensitivity/stator_on_mesh.h>
#include <ringmotor/wave/body_modes.h>

namespace ringmotor
{
  namespace
  {
    /** Frequencies of stators like the reference motor's to 4e-4. */
    constexpr BodyDiscretisation mesh{3, 1};

    /** The parameters that ask for the motor's wave alone. */
    Parameters asking_for_wave(Parameters parameters)
    {
      parameters.modes.body = Body::stator;
      parameters.modes.nodal_diameters.clear();
      return parameters;
    }

    WaveMotion times(const WaveMotion &motion, const double factor)
    {
      return [=](const dealii::Point<3> &x)
      {
        auto u = motion(x);
        for (auto &component : u)
          component *= factor;
        return u;
      };
    }

    WaveEnergies energies_of(const WaveResult &result)
    {
      const auto &strain = result.energy.strain;
      WaveEnergies energies;
      energies.angular_frequency = result.angular_frequency;
      energies.amplitude         = result.amplitude;
      energies.metal             = strain.at(ids::base) + strain.at(ids::tooth);
      energies.piezoceramic      = strain.at(ids::piezoceramic);
      return energies;
    }
  } // namespace

  WaveEnergies StatorOnMesh::energies_on(const Parameters &parameters) const
  {
    WaveEnergies all = energies;
    all.felt         = felt_energy(parameters.support, stator_shape(parameters)->on_felt(),
                                   parameters.motor.n_teeth, bottom);
    return all;
  }

  StatorOnMesh StatorOnMesh::at(const double amplitude) const
  {
    const double factor      = amplitude / wave.amplitude;
    StatorOnMesh other       = *this;
    other.wave.amplitude     = amplitude;
    other.wave.foot          = times(wave.foot, factor);
    other.wave.top           = times(wave.top, factor);
    other.wave.strain_energy = factor * factor * wave.strain_energy;
    return other; // the energies and what tells that of the felt keep their own amplitude
  }

  Parameters with_stator_effects(const Parameters &parameters)
  {
    BodyModes body(asking_for_wave(parameters), MPI_COMM_SELF);
    body.locate();
    Parameters decided = parameters;
    for (const EffectRow &row : body.effects())
      decided.effects[row.name] = row.choice == "on" ? EffectChoice::on : EffectChoice::off;
    return decided;
  }

  StatorOnMesh stator_on_mesh(const Parameters &parameters)
  {
    BodyModes body(asking_for_wave(parameters), MPI_COMM_SELF);
    body.locate();
    StatorOnMesh stator;
    stator.n_dofs            = body.compute(mesh).n_dofs;
    const WaveResult *result = body.wave();
    if (result == nullptr)
      throw ComputationError("the motor's wave is not among the modes of a coarse mesh");
    const CyclicSector &sector = body.search().sector();
    const Mode &mode           = result->found.mode;
    const auto motion          = [&](const Surface surface)
    { return motion_of(surface_trace(sector, mode, surface)); };
    stator.natural_frequency      = result->found.frequency.value;
    stator.energies               = energies_of(*result);
    stator.bottom                 = motion(Surface::bottom);
    stator.wave.n_waves           = mode.nodal_diameter;
    stator.wave.angular_frequency = result->angular_frequency;
    stator.wave.amplitude         = result->amplitude;
    stator.wave.strain_energy     = result->energy.total_strain;
    stator.wave.foot              = motion(Surface::tooth_foot);
    stator.wave.top               = motion(Surface::tooth_top);
    return stator;
  }

  NearbyStators::NearbyStators(const Parameters &parameters)
      : first(with_stator_effects(parameters)), of_first(stator_on_mesh(first))
  {
  }

  StatorOnMesh NearbyStators::of(const Parameters &other) const
  {
    Parameters with_first_amplitude     = other;
    with_first_amplitude.wave.amplitude = first.wave.amplitude;
    const std::string its               = text_of(relevant_for_wave(with_first_amplitude));
    if (its == text_of(relevant_for_wave(first)))
      return other.wave.amplitude == first.wave.amplitude ? of_first
                                                          : of_first.at(other.wave.amplitude);
    auto stator = known.find(its);
    if (stator == known.end())
      stator = known.emplace(its, stator_on_mesh(with_first_amplitude)).first;
    if (stator->second.n_dofs != of_first.n_dofs)
      throw ComputationError("the stator's mesh gets other cells");
    return other.wave.amplitude == first.wave.amplitude ? stator->second
                                                        : stator->second.at(other.wave.amplitude);
  }
} // namespace ringmotor
