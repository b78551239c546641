// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/surface_compliance.h>
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/body_parts.h>
#include <ringmotor/motor/motor_model.h>
#include <ringmotor/motor/smooth_loads.h>
#include <ringmotor/motor/stator_modes.h>
#include <ringmotor/motor/tooth_modes.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/motion_products.h>
#include <ringmotor/structure/response_modes.h>
#include <ringmotor/structure/shared_work.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    /** The degree, and the level of the mesh of a stator. */
    struct Resolution
    {
      unsigned int degree, mesh;
    };

    /** Each level of a file's mesh has eight times the cells of the one before, so that the degree
     * grows first. */
    Resolution resolution(const StatorShape &stator, const unsigned int level)
    {
      if (stator.origin.is_sector)
        return {2 + (level + 1) / 2, level / 2};
      return {level < RotorVibration::finest_level ? 2u : 3u, level};
    }

    SectorMesh with_parts(SectorMesh mesh, const Parameters &parameters)
    {
      add_to_stator(motor_model(parameters), mesh);
      return mesh;
    }

    MaterialTable materials_of(const Parameters &parameters)
    {
      return material_table(parameters.materials, Body::stator, motor_model(parameters).ceramic);
    }

    /** Forces in both directions along the tops of the teeth and across them. */
    constexpr LoadDegrees degrees_of_loads{3, 1};

    /** The motion of the tooth tops in the wave, at the nodes of a surface of the whole tooth that
     * are meshed; zero at the others. */
    std::vector<std::array<Complex, 3>> wave_at(const SectorSurface &top, const WaveMotion &wave)
    {
      std::vector<std::array<Complex, 3>> motion(top.origin.size());
      for (std::size_t i = 0; i < motion.size(); ++i)
        if (!top.origin[i].mirrored)
        {
          const Point<2> &place = top.surface.nodes[i].place;
          const auto u =
              wave(Point<3>(place[0] * std::cos(place[1]), place[0] * std::sin(place[1]), 0.));
          motion[i] = {{u[2], -u[1], u[0]}};
        }
      return motion;
    }

    /** The cosine of the angle between two motions, where the first one is not zero. */
    double likeness(const std::vector<std::array<Complex, 3>> &one,
                    const std::vector<std::array<Complex, 3>> &other)
    {
      Complex product = 0.;
      double of_one = 0., of_other = 0.;
      for (std::size_t i = 0; i < one.size(); ++i)
        if (one[i] != std::array<Complex, 3>())
          for (unsigned int c = 0; c < 3; ++c)
          {
            product += std::conj(one[i][c]) * other[i][c];
            of_one += std::norm(one[i][c]);
            of_other += std::norm(other[i][c]);
          }
      return std::abs(product) / std::sqrt(of_one * of_other);
    }

    /** Takes the mode that is the wave out of those with as many waves. */
    RingMode take_driven(std::vector<RingMode> &modes, const SectorSurface &top,
                         const StatorWave &wave)
    {
      constexpr double least_alike = 0.9, near = 1.25; // also on the coarsest mesh
      const std::vector<std::array<Complex, 3>> motion = wave_at(top, wave.top);
      auto driven                                      = modes.end();
      double most_alike                                = least_alike;
      for (auto mode = modes.begin(); mode != modes.end(); ++mode)
      {
        const double ratio = mode->angular_frequency / wave.angular_frequency,
                     alike = mode->part == ModePart::stator ? likeness(motion, mode->motion) : 0.;
        if (ratio < near && ratio > 1. / near && alike > most_alike)
        {
          driven     = mode;
          most_alike = alike;
        }
      }
      if (driven == modes.end())
        throw ComputationError(
            "Effects/Stator compliance: none of the stator's modes with " +
            std::to_string(wave.n_waves) +
            " waves under contact forces moves the teeth as the wave does; choose "
            "Effects/Stator compliance = off, or Wave/Frequency near the natural one");
      const RingMode taken = *driven;
      modes.erase(driven);
      return taken;
    }

    /** Finds the modes of one nodal diameter after the other. */
    class StatorModeSolver
    {
    public:
      StatorModeSolver(const StatorBody &body, const MaterialTable &materials)
          : body(body), materials(materials), of_stator(body.sector), of_tooth(body.tooth)
      {
      }

      /** @param frequencies rad/s, ascending, of the forces, besides constant ones */
      std::vector<RingMode> modes(const unsigned int k, const std::vector<double> &frequencies)
      {
        constexpr double far = 3.; // as without_fast_vectors()
        const double lowest  = frequencies.empty() ? 0. : frequencies.front(),
                     fastest = frequencies.empty() ? 0. : far * frequencies.back();
        std::vector<RingMode> modes;
        const std::vector<Mode> found =
            of_stator.at(k, smooth_loads(body.sector, body.top, k, degrees_of_loads), frequencies);
        const std::vector<double> factors = loss_factors(found);
        for (std::size_t i = 0; i < found.size(); ++i)
        {
          modes.push_back(mode_on_surface(body.sector, body.top, body.whole_top.origin, found[i],
                                          ModePart::stator));
          modes.back().loss_factor = factors[i];
          if (modes.back().angular_frequency > fastest)
            make_constant(modes.back(), lowest);
        }
        for (const Mode &mode : of_tooth.at(
                 0, smooth_loads(body.tooth, body.top_of_tooth, 0, degrees_of_loads), frequencies))
        {
          modes.push_back(mode_on_surface(body.tooth, body.top_of_tooth, body.whole_top.origin,
                                          mode, ModePart::tooth));
          modes.back().response = ModeResponse::none;
        }
        return modes;
      }

    private:
      /** Lets a fast vector respond at all frequencies as at the @p lowest one, which matters most.
       */
      static void make_constant(RingMode &mode, const double lowest)
      {
        mode.response       = ModeResponse::as_at_rest;
        const double factor = 1. / std::sqrt(1. - std::pow(lowest / mode.angular_frequency, 2));
        for (std::array<Complex, 3> &motion : mode.motion)
          for (Complex &component : motion)
            component *= factor;
      }

      /** Those of the materials, weighted by their strain energies in each mode. */
      std::vector<double> loss_factors(const std::vector<Mode> &modes) const
      {
        std::vector<const SectorMotion *> motions;
        for (const Mode &mode : modes)
          motions.push_back(&mode.motion);
        std::vector<double> factors;
        for (const MotionProducts &products : motion_products(body.sector, motions))
        {
          factors.push_back(0.);
          for (const auto &[part, loss_factor] : loss_factor_by_part(materials, products.stiffness))
            factors.back() += loss_factor;
        }
        return factors;
      }

      const StatorBody &body;
      const MaterialTable materials;
      ResponseModes of_stator, of_tooth;
    };
  } // namespace

  StatorBody::StatorBody(const Parameters &parameters, const unsigned int level)
      : StatorBody(*stator_shape(parameters), parameters, level)
  {
  }

  StatorBody::StatorBody(const StatorShape &stator, const Parameters &parameters,
                         const unsigned int level)
      : mesh(with_parts(stator.sector(resolution(stator, level).mesh, MPI_COMM_SELF), parameters)),
        tooth_mesh(
            with_parts(stator.tooth(resolution(stator, level).mesh, MPI_COMM_SELF), parameters)),
        sector(mesh, materials_of(parameters), resolution(stator, level).degree),
        tooth(tooth_mesh, materials_of(parameters), resolution(stator, level).degree),
        top(solid_surface(sector, ids::tooth_top)),
        top_of_tooth(solid_surface(tooth, ids::tooth_top)),
        whole_top(whole_surface(top, SectorForm::half)), is_clamped(stator.has_face(ids::clamped))
  {
  }

  StatorModes::StatorModes(const Parameters &parameters, const StatorWave &wave,
                           const unsigned int level, const unsigned int n_harmonics,
                           const MPI_Comm communicator)
      : modes(parameters.motor.n_teeth / 2 + 1)
  {
    const StatorBody body(parameters, level);
    top            = body.whole_top;
    auto harmonics = harmonics_by_diameter(parameters.motor, n_harmonics);
    if (body.is_clamped)
      harmonics[0]; // the mean forces
    StatorModeSolver solver(body, materials_of(parameters));
    std::vector<unsigned int> diameters;
    for (const auto &[k, of_diameter] : harmonics)
      if (k >= body.least_diameter())
        diameters.push_back(k);
    const auto found = shared_work(
        diameters,
        [&](const unsigned int k)
        {
          std::vector<double> frequencies;
          for (const unsigned int harmonic : harmonics.at(k))
            frequencies.push_back(harmonic * wave.angular_frequency);
          return solver.modes(k, frequencies);
        },
        communicator);
    for (std::size_t i = 0; i < diameters.size(); ++i)
      modes[diameters[i]] = found[i];
    of_wave = take_driven(modes.at(nodal_diameter_of_harmonic(parameters.motor, 1)), top, wave);
  }

  RingModes StatorModes::at(const ContactSurface &tooth_top, const MortarCoupling &mortar) const
  {
    RingModes at_points(modes.size());
    const std::vector<SurfaceWeights> weights = weights_on(top.surface, tooth_top, mortar);
    for (std::size_t k = 0; k < modes.size(); ++k)
      for (const RingMode &mode : modes[k])
        at_points[k].push_back(interpolated(mode, weights));
    return at_points;
  }

  StatorVibration::StatorVibration(const Parameters &parameters, const StatorWave &wave,
                                   const MPI_Comm communicator)
      : parameters(parameters), wave(wave), communicator(communicator)
  {
  }

  const StatorModes &StatorVibration::modes(const VibrationSetting &setting) const
  {
    std::shared_ptr<const StatorModes> &modes = known[{setting.mesh, setting.n_low}];
    if (!modes)
      modes = std::make_shared<const StatorModes>(parameters, wave, setting.mesh, setting.n_low,
                                                  communicator);
    return *modes;
  }

  MotorVibration::MotorVibration(const Parameters &parameters, const StatorWave &wave,
                                 const MPI_Comm communicator)
      : rotor(parameters, wave.angular_frequency, communicator),
        stator(parameters, wave, communicator)
  {
  }

  void MotorVibration::prepare(const MotorModel &model, const unsigned int modes_level,
                               const ModeSets sets) const
  {
    if (model.rotor_needs_modes())
      rotor.prepare(modes_level, sets);
    if (model.stator_gives_way)
      for (const VibrationSetting &setting : rotor.settings(modes_level, sets))
        stator.modes(setting);
  }
} // namespace ringmotor
