// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_shape.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/output/hdf5.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/output/modes_file.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/fingerprint.h>
#include <ringmotor/parameters/short_text.h>
#include <ringmotor/pictures/trace_motion.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** How many intervals a lattice of points has along each side of a face or cell. */
    unsigned int lattice_order(const Hdf5Reader &file, const std::string &group)
    {
      return file.attribute_between<unsigned int>(group, "order", 1, 20);
    }

    /** How many faces or cells a dataset is about: at least one. */
    std::size_t n_entities(const Hdf5Reader &file, const std::string &name)
    {
      const std::vector<std::size_t> dims = file.dims(name);
      return dims.empty() ? 1 : std::max<std::size_t>(1, dims[0]);
    }

    /** A trace as write_modes_h5() has written it. */
    SurfaceTrace read_trace(const Hdf5Reader &file, const std::string &surface)
    {
      const std::string group = "/wave/" + surface;
      SurfaceTrace trace;
      trace.order                 = lattice_order(file, group);
      trace.n_faces               = n_entities(file, group + "/points");
      const std::size_t n_lattice = (trace.order + 1) * (trace.order + 1);
      const std::vector<std::size_t> dims{trace.n_faces, n_lattice, 3};
      const auto points    = file.read<double>(group + "/points", dims, "m");
      const auto real      = file.read<double>(group + "/displacement_real", dims, "m");
      const auto imaginary = file.read<double>(group + "/displacement_imaginary", dims, "m");
      for (std::size_t i = 0; i < points.size(); i += 3)
      {
        trace.points.emplace_back(points[i], points[i + 1], points[i + 2]);
        trace.displacement.push_back({{{real[i], imaginary[i]},
                                       {real[i + 1], imaginary[i + 1]},
                                       {real[i + 2], imaginary[i + 2]}}});
      }
      return trace;
    }

    /** All that the motion of a trace depends on. */
    std::string bytes_of(const SurfaceTrace &trace)
    {
      std::vector<double> points, real, imaginary;
      for (std::size_t i = 0; i < trace.points.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
        {
          points.push_back(trace.points[i][c]);
          real.push_back(trace.displacement[i][c].real());
          imaginary.push_back(trace.displacement[i][c].imag());
        }
      return to_bytes(trace.order) + to_bytes(points) + to_bytes(real) + to_bytes(imaginary);
    }

    const std::string &existing(const std::string &path)
    {
      if (!std::filesystem::exists(path))
        throw UserError(path + " does not exist: the stator's wave is needed; run the program "
                               "stator with the same parameter file first");
      return path;
    }

    /** @throws UserError if the file is of another motor, or has no wave */
    void require_motor_of(const Parameters &parameters, const Hdf5Reader &file,
                          const std::string &path)
    {
      const std::string other =
          difference(file.attribute<std::string>("/", "parameters"), relevant_for_wave(parameters));
      if (!other.empty())
        throw UserError(path + " belongs to another motor: " + other +
                        "; run the program stator with these parameters first");
      const std::string n_waves = std::to_string(parameters.motor.n_waves);
      if (!file.has("wave"))
        throw UserError(path + " has modes, but none of them is the wave of the motor (" + n_waves +
                        " waves, out of plane); Modes/Nodal diameters must include " + n_waves +
                        ", and Modes/Number of modes must be large enough; then run the program "
                        "stator again");
    }

    /** @param cause what its error counts as */
    Estimate shape_number(const Hdf5Reader &file, const std::string &name,
                          const std::string &cause = causes::wave)
    {
      return {file.attribute<double>("/wave/shape", name),
              file.attribute<double>("/wave/shape", name + " error"), cause};
    }

    Estimate natural_frequency(const Hdf5Reader &file, const std::string &cause)
    {
      return {file.attribute<double>("/wave", "natural_frequency_Hz"),
              file.attribute<double>("/wave", "natural_frequency_error_Hz"), cause};
    }

    /** A mode of the teeth may look like one of the ring; it drives no rotor.
     * @throws UserError for tooth tops that move far more along the ring than axially, or hardly */
    void check_drives(const double ratio, const StatorWave &wave)
    {
      constexpr double least = 0.005, most = 20.;
      if (ratio >= least && ratio <= most)
        return;
      std::ostringstream text;
      text << "the wave with " << wave.n_waves << " waves at "
           << 1e-3 * wave.angular_frequency / (2. * M_PI)
           << " kHz moves the tooth tops along the ring " << ratio
           << " times as far as axially; plausible: " << least << " to " << most
           << "; choose another Motor/Number of waves or other dimensions of the stator, or, if it "
              "is meant, set Motor/Unusual values = accept";
      throw UserError(text.str());
    }
  } // namespace

  ModesFile::ModesFile(const std::string &path, const Parameters &parameters)
      : path(path), parameters(parameters),
        reader(std::make_unique<const Hdf5Reader>(existing(path), "ringmotor modes",
                                                  modes_format_version))
  {
    require_motor_of(parameters, *reader, path);
  }

  ModesFile::ModesFile(const Parameters &parameters)
      : ModesFile(parameters.output.directory + "/stator/modes.h5", parameters)
  {
  }

  ModesFile::~ModesFile() = default;

  StatorWave ModesFile::wave() const
  {
    const Hdf5Reader &file = *reader;
    StatorWave wave;
    wave.n_waves            = file.attribute<unsigned int>("/wave", "nodal_diameter");
    wave.angular_frequency  = file.attribute<double>("/wave", "angular_frequency_rad_per_s");
    wave.amplitude          = file.attribute<double>("/wave", "amplitude_m");
    const SurfaceTrace foot = read_trace(file, "tooth_foot"), top = read_trace(file, "tooth_top");
    wave.relative_error = file.attribute<double>("/wave", "relative_error");
    wave.strain_energy  = shape_number(file, "strain_energy").value;
    if (!parameters.motor.accepts_unusual_values)
      check_drives(shape_number(file, "A_t/A_n").value, wave);
    wave.foot        = motion_of(foot);
    wave.top         = motion_of(top);
    wave.fingerprint = fingerprint(bytes_of(foot) + bytes_of(top) + to_bytes(wave.n_waves) +
                                   to_bytes(wave.angular_frequency));
    return wave;
  }

  WaveEnergies ModesFile::energies() const
  {
    const Hdf5Reader &file = *reader;
    WaveEnergies energies;
    energies.angular_frequency = file.attribute<double>("/wave", "angular_frequency_rad_per_s");
    energies.amplitude         = file.attribute<double>("/wave", "amplitude_m");
    energies.metal =
        shape_number(file, "strain_energy_base") + shape_number(file, "strain_energy_tooth");
    energies.piezoceramic = shape_number(file, "strain_energy_piezoceramic");
    // The motion of the lower side is as accurate as the energy of the whole wave.
    energies.felt = felt_energy(parameters.support, stator_shape(parameters)->on_felt(),
                                parameters.motor.n_teeth, motion_of(read_trace(file, "bottom"))) *
                    shape_number(file, "strain_energy").relative();
    for (Estimate *energy : {&energies.metal, &energies.piezoceramic, &energies.felt})
      *energy = *energy * natural_frequency(file, causes::wave).relative(); // as losses scale
    return energies;
  }

  std::optional<DrivenWave> ModesFile::driven_wave() const
  {
    const Hdf5Reader &file = *reader;
    if (!file.has("circuits"))
      return {};
    DrivenWave wave;
    wave.amplitude         = file.attribute<double>("/wave", "amplitude_m");
    wave.natural_frequency = natural_frequency(file, causes::wave);
    wave.modal_mass        = shape_number(file, "modal_mass", causes::wave);
    wave.electric_energy   = shape_number(file, "electric_energy", causes::wave);
    for (const Phase phase : both_phases)
    {
      const std::string group = "/circuits/" + name_of(phase);
      const auto number       = [&](const std::string &name)
      {
        return Estimate(file.attribute<double>(group, name),
                        file.attribute<double>(group, name + " error"), causes::wave);
      };
      wave.force_factor[PhaseHarmonics::index(phase)]         = number("force_factor_N_per_V");
      wave.parallel_capacitance[PhaseHarmonics::index(phase)] = number("C0_F");
    }
    wave.standing_part =
        ElectrodeLayout(parameters.electrodes, parameters.motor, mean_radius_of_ceramic(parameters))
            .standing_part(parameters.motor.n_waves);
    wave.dielectric_loss_factor    = parameters.piezoelectricity.dielectric_loss_factor;
    wave.piezoelectric_loss_factor = parameters.piezoelectricity.piezoelectric_loss_factor;
    wave.frequency                 = parameters.wave.frequency;
    if (parameters.wave.drive == Drive::voltage)
      wave.voltage = parameters.wave.voltage;
    return wave;
  }

  SectorField ModesFile::body() const
  {
    const Hdf5Reader &file  = *reader;
    const std::string group = "/wave/body";
    SectorField body;
    body.order                  = lattice_order(file, group);
    body.n_sectors              = parameters.motor.n_teeth;
    body.nodal_diameter         = file.attribute<unsigned int>("/wave", "nodal_diameter");
    body.angular_frequency      = file.attribute<double>("/wave", "angular_frequency_rad_per_s");
    const std::size_t n_lattice = (body.order + 1) * (body.order + 1) * (body.order + 1);
    const std::size_t n_cells   = n_entities(file, group + "/material");
    const auto points = file.read<double>(group + "/points", {n_cells, n_lattice, 3}, "m");
    const auto energy = file.read<double>(group + "/strain_energy", {n_cells, n_lattice}, "J/m^3");
    const auto material = file.read<unsigned int>(group + "/material", {n_cells}, "1");
    const auto part     = [&](const std::string &name) {
      return file.read<double>(group + "/displacement_" + name, {n_cells, n_lattice, 3}, "m");
    };
    const auto real = part("real"), imaginary = part("imaginary");
    for (std::size_t i = 0; i < n_cells * n_lattice; ++i)
    {
      if (i % n_lattice == 0)
        body.cells.push_back({{}, {}, {}, material[i / n_lattice]});
      SectorField::Cell &cell = body.cells.back();
      cell.points.emplace_back(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
      cell.strain_energy.push_back(energy[i]);
      cell.displacement.emplace_back();
      for (unsigned int d = 0; d < 3; ++d)
        cell.displacement.back()[d] = {real[3 * i + d], imaginary[3 * i + d]};
    }
    return body;
  }

  StatorWave read_stator_wave(const ModesFile &file, const Parameters &parameters)
  {
    StatorWave wave = file.wave();
    if (parameters.wave.drive != Drive::voltage)
      return wave;
    const std::optional<DrivenWave> driven = file.driven_wave();
    if (!driven)
      throw UserError(file.path +
                      " has no circuits of the phases, which Wave/Drive = voltage needs, as "
                      "Effects/Piezoelectric coupling = auto was off; set it to on and run the "
                      "program stator again");
    add_voltage_drive(wave, *driven, file.energies(), parameters);
    return wave;
  }
} // namespace ringmotor
