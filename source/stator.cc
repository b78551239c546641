// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/mesh/read_sector.h>
#include <ringmotor/mesh/stator_sector.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/log.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/output/summary.h>
#include <ringmotor/output/vtu.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/programs/run_program.h>
#include <ringmotor/version.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    struct Quantity
    {
      std::string name;
      double value;
      std::string unit;
    };

    /**
     * The program `stator`: natural modes of the stator and its travelling wave, from a mesh that
     * is refined until the frequencies are as accurate as asked for.
     */
    class StatorProgram
    {
    public:
      explicit StatorProgram(const Parameters &parameters);
      void run();

    private:
      SectorMesh make_mesh(const unsigned int level) const;
      void find_modes();
      void compute_pass(const unsigned int degree);
      bool accurate_enough() const;
      WaveResult make_wave(const FoundMode &working) const;
      std::vector<Quantity> quantities_of(const WaveResult &wave) const;
      void report();
      void write_results();
      void write_summary_file(const std::string &folder);
      void add_wave_quantities(Summary &summary, const double seconds) const;

      const Parameters &parameters;
      const MPI_Comm communicator = MPI_COMM_WORLD;
      const bool speaks;
      Log log;
      Phases phases;

      SectorMesh mesh;
      ModeSearch search;
      unsigned int n_passes = 0;

      // Quantities of the wave's shape, pass by pass: their change is what their error bars are
      // made from.
      struct ShapeSample
      {
        std::vector<Quantity> quantities;
        double indicator;
      };
      std::vector<ShapeSample> shape_samples;
      std::optional<WaveResult> wave;
    };

    std::string text(const double value, const int digits)
    {
      std::ostringstream out;
      out << std::fixed << std::setprecision(digits) << value;
      return out.str();
    }

    MaterialTable material_table(const Materials &materials)
    {
      return {{ids::base, materials.stator_metal},
              {ids::tooth, materials.stator_metal},
              {ids::piezoceramic, materials.piezoceramic}};
    }

    StatorProgram::StatorProgram(const Parameters &parameters)
        : parameters(parameters), speaks(Utilities::MPI::this_mpi_process(communicator) == 0),
          log(speaks), search(material_table(parameters.materials), parameters.modes)
    {
    }

    void StatorProgram::run()
    {
      if (speaks)
        prepare_directory(parameters.output.directory + "/stator");
      find_modes();
      report();
      write_results();
    }

    SectorMesh StatorProgram::make_mesh(const unsigned int level) const
    {
      if (parameters.stator.mesh_file.empty())
        return make_stator_sector(parameters.stator, parameters.motor.n_teeth, SectorForm::half,
                                  SectorGrading::level(level), communicator);
      SectorMesh sector =
          read_sector(parameters.stator.mesh_file, parameters.motor.n_teeth, communicator);
      if (parameters.accuracy.mode == AccuracyMode::fixed)
        sector.triangulation->refine_global(level);
      return sector;
    }

    /** Degree and grading that reach a target in one pass for stators like the reference one. */
    struct Start
    {
      unsigned int degree, level;
    };
    Start start_for(const double target)
    {
      return target >= 2e-3     ? Start{3, 0}
             : target >= 6e-4   ? Start{3, 1}
             : target >= 1.5e-4 ? Start{3, 2}
             : target >= 5e-5   ? Start{3, 3}
                                : Start{4, 3};
    }

    void StatorProgram::find_modes()
    {
      const bool fixed = parameters.accuracy.mode == AccuracyMode::fixed;
      const Start start =
          fixed ? Start{parameters.accuracy.polynomial_degree, parameters.accuracy.refinement}
                : start_for(parameters.accuracy.target);
      // A cheap first pass finds out where the modes lie and gives the error bars something to
      // compare with.
      mesh = make_mesh(0);
      compute_pass(start.degree - 1);

      mesh = make_mesh(start.level);
      compute_pass(start.degree);
      const unsigned int most_passes = 12, most_dofs = 600000;
      while (!fixed && !accurate_enough())
      {
        if (n_passes == most_passes || search.sector().dofs().n_dofs() > most_dofs)
          throw ComputationError(
              "the frequencies are known to " + text(1e6 * search.worst_relative_error(), 1) +
              "e-6 after " + std::to_string(n_passes) + " passes, the last one with " +
              std::to_string(search.sector().dofs().n_dofs()) +
              " degrees of freedom, not to Accuracy/Target = " +
              std::to_string(parameters.accuracy.target) + "; choose a larger target");
        search.refine(mesh);
        compute_pass(start.degree);
      }
    }

    bool StatorProgram::accurate_enough() const
    {
      return search.worst_relative_error() <= parameters.accuracy.target;
    }

    void StatorProgram::compute_pass(const unsigned int degree)
    {
      const auto scope = phases.measure("modes, pass " + std::to_string(++n_passes));
      const auto begin = std::chrono::steady_clock::now();
      search.compute(mesh, degree);
      const double seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

      const FoundMode *working = search.working_mode(parameters.motor.n_waves);
      const FoundMode &shown   = working != nullptr ? *working : search.modes().front();
      log.line("pass " + std::to_string(n_passes) + ": degree " + std::to_string(degree) + ", " +
               std::to_string(mesh.triangulation->n_active_cells()) + " cells, " +
               std::to_string(search.sector().dofs().n_dofs()) +
               " dofs: f(n = " + std::to_string(shown.mode.nodal_diameter) + ", " +
               to_string(shown.content.family()) + ") = " + text(1e-3 * shown.frequency.value, 5) +
               " +- " + text(1e-3 * shown.frequency.error, 5) +
               " kHz, worst relative error of all modes " +
               text(1e6 * search.worst_relative_error(), 0) + "e-6, " + text(seconds, 2) + " s");
      if (working != nullptr)
      {
        wave = make_wave(*working);
        shape_samples.push_back({quantities_of(*wave), working->samples.back().indicator});
      }
    }

    WaveResult StatorProgram::make_wave(const FoundMode &working) const
    {
      const std::vector<ToothPoint> points = tooth_points(search.sector());
      WaveResult result;
      result.found     = working;
      result.amplitude = parameters.wave.amplitude;
      result.angular_frequency =
          2. * numbers::PI * parameters.wave.frequency.value_or(working.frequency.value);
      normalise_to_amplitude(result.found.mode, points, result.amplitude);
      for (const ToothPoint &point : points)
        result.points.push_back({point, elliptic_motion(point, result.found.mode)});
      result.energy     = wave_energy(search.sector(), result.found.mode);
      result.modal_mass = modal_mass(result.energy, result.found.mode, result.amplitude);
      for (const FoundMode &other : search.modes())
        if (other.mode.nodal_diameter == working.mode.nodal_diameter)
        {
          const double gap = other.frequency.value / working.frequency.value - 1.;
          double &nearest  = gap > 0. ? result.gap_above : result.gap_below;
          if (gap != 0. && (nearest == 0. || std::abs(gap) < nearest))
            nearest = std::abs(gap);
        }
      return result;
    }

    std::vector<Quantity> StatorProgram::quantities_of(const WaveResult &wave) const
    {
      const auto motion = [&](const std::string &name)
      {
        return std::find_if(wave.points.begin(), wave.points.end(),
                            [&](const PointResult &result) { return result.point.name == name; })
            ->motion;
      };
      const EllipticMotion center = motion("top_outer_C");
      return {{"A_t/A_n", center.tangential / center.normal, "1"},
              {"A_r/A_n", center.radial / center.normal, "1"},
              {"phi_edge", motion("top_outer_R").phi * 180. / numbers::PI, "deg"},
              {"modal_mass", wave.modal_mass, "kg"},
              {"strain_energy", wave.energy.total_strain, "J"},
              {"strain_energy_base", wave.energy.strain.at(ids::base), "J"},
              {"strain_energy_tooth", wave.energy.strain.at(ids::tooth), "J"},
              {"strain_energy_piezoceramic", wave.energy.strain.at(ids::piezoceramic), "J"}};
    }

    void StatorProgram::report()
    {
      for (const FoundMode &found : search.modes())
        log.line("n = " + std::to_string(found.mode.nodal_diameter) + " " +
                 to_string(found.content.family()) + ": " + text(1e-3 * found.frequency.value, 5) +
                 " +- " + text(1e-3 * found.frequency.error, 5) + " kHz");
      if (wave)
        log.line("wave: A_t/A_n = " + text(shape_samples.back().quantities[0].value, 4) +
                 " at the outer edge of the tooth top, gap to the next mode " +
                 text(100. * wave->gap_above, 1) + " % above");
      else
        log.line("the motor's wave (n = " + std::to_string(parameters.motor.n_waves) +
                 ", out-of-plane) is not among the modes asked for: no ellipses, no wave for the "
                 "contact");
    }

    void StatorProgram::write_results()
    {
      const std::string folder = parameters.output.directory + "/stator/";
      if (speaks)
      {
        const auto scope = phases.measure("output");
        write_file(folder + "used.prm",
                   [&](std::ostream &out)
                   {
                     out << "# used by stator of ringmotor " << version << " (" << git_revision
                         << ")\n";
                     print_parameters(out, parameters);
                   });
        write_frequencies(folder + "frequencies.csv", search.modes());
        write_modes_h5(folder + "modes.h5", parameters, search.sector(), search.modes(),
                       wave ? &*wave : nullptr);
        if (wave)
          write_ellipses(folder + "ellipses.csv", *wave);
      }
      if (speaks && wave && parameters.output.vtu)
      {
        const auto scope          = phases.measure("output for ParaView");
        const unsigned int degree = search.sector().dofs().get_fe().degree;
        write_sector(folder + "sector.vtu",
                     sample_sector(search.sector(), wave->found.mode, degree));
        write_ring_animation(folder, "ring", sample_sector(search.sector(), wave->found.mode, 2),
                             parameters.output.frames_per_period);
      }
      if (speaks)
        write_summary_file(folder);
      log.line("results in " + folder);
    }

    void StatorProgram::write_summary_file(const std::string &folder)
    {
      Summary summary;
      summary.program = "stator";
      summary.version = version;
      summary.git     = git_revision;
      std::ostringstream prm;
      print_parameters(prm, parameters);
      summary.prm            = prm.str();
      summary.seconds        = phases.seconds();
      summary.peak_memory_MB = peak_memory_MB();
      summary.dofs           = search.sector().dofs().n_dofs();
      double seconds         = 0.;
      for (const auto &phase : phases.seconds())
        seconds += phase.second;
      for (const FoundMode &found : search.modes())
        summary.quantities.push_back(
            {"frequency",
             found.frequency.value,
             "Hz",
             found.frequency.error,
             {{"body mesh", found.frequency.error}},
             seconds,
             {{"n", found.mode.nodal_diameter}, {"family", to_string(found.content.family())}}});
      if (wave)
        add_wave_quantities(summary, seconds);
      summary.effects.push_back({"Target plates", 0., "off", 0., 0});
      summary.certificate.push_back({"modes missed by the eigensolver (Sturm count)", 0., 0.});
      if (parameters.accuracy.mode == AccuracyMode::adaptive)
        summary.certificate.push_back({"largest relative error bar of a frequency",
                                       search.worst_relative_error(), parameters.accuracy.target});
      write_summary(folder + "summary.json", summary);
    }

    void StatorProgram::add_wave_quantities(Summary &summary, const double seconds) const
    {
      const ShapeSample &last = shape_samples.back(), &earlier = *(shape_samples.end() - 2);
      for (unsigned int i = 0; i < last.quantities.size(); ++i)
      {
        const Quantity &quantity = last.quantities[i];
        const Estimate estimate  = shape_estimate(quantity.value, earlier.quantities[i].value,
                                                  last.indicator, earlier.indicator);
        summary.quantities.push_back({quantity.name,
                                      estimate.value,
                                      quantity.unit,
                                      estimate.error,
                                      {{"body mesh", estimate.error}},
                                      seconds,
                                      {}});
      }
    }

  } // namespace
} // namespace ringmotor

int main(int argc, char **argv)
{
  using namespace ringmotor;
  return run_program(
      argc, argv, "stator", "Computes natural modes of the stator and its travelling wave.",
      check_for_stator, [](const Parameters &parameters) { StatorProgram(parameters).run(); });
}
