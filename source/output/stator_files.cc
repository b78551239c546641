// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/output/hdf5.h>
#include <ringmotor/output/stator_files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/pictures/sector_field.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int body_order = 2; ///< of the lattice in cells, for pictures

    void write_mode_list(Hdf5Writer &file, const std::vector<FoundMode> &modes)
    {
      std::vector<unsigned int> nodal_diameter;
      std::vector<std::string> family;
      std::vector<double> frequency, error;
      for (const FoundMode &found : modes)
      {
        nodal_diameter.push_back(found.mode.nodal_diameter);
        family.push_back(to_string(found.content.family()));
        frequency.push_back(found.frequency.value);
        error.push_back(found.frequency.error());
      }
      const std::vector<std::size_t> dims{modes.size()};
      file.write("modes/nodal_diameter", nodal_diameter, dims, "1",
                 "number of waves around the ring of each mode");
      file.write("modes/family", family, dims, "",
                 "dominant motion of the cross-section in each mode");
      file.write("modes/frequency", frequency, dims, "Hz", "natural frequency of each mode");
      file.write("modes/frequency_error", error, dims, "Hz", "error bar of the natural frequency");
    }

    /** @param components of the vectors, as the file calls them */
    void write_displacement(Hdf5Writer &file, const std::string &group,
                            const std::vector<std::array<std::complex<double>, 3>> &displacement,
                            const std::vector<std::size_t> &dims, const std::string &components)
    {
      std::vector<double> real, imaginary;
      for (const auto &u : displacement)
        for (const std::complex<double> &component : u)
        {
          real.push_back(component.real());
          imaginary.push_back(component.imag());
        }
      file.write(group + "/displacement_real", real, dims, "m",
                 "real part of the " + components + " components of U at the points");
      file.write(group + "/displacement_imaginary", imaginary, dims, "m",
                 "imaginary part of the same");
    }

    void write_trace(Hdf5Writer &file, const std::string &group, const SurfaceTrace &trace)
    {
      const std::size_t n_face_points = (trace.order + 1) * (trace.order + 1);
      std::vector<double> points;
      for (const Point<3> &point : trace.points)
        points.insert(points.end(), {point[0], point[1], point[2]});
      const std::vector<std::size_t> dims{trace.n_faces, n_face_points, 3};
      file.write(group + "/points", points, dims, "m",
                 "x, y, z of a lattice of (order + 1)^2 points on each face");
      write_displacement(file, group, trace.displacement, dims, "r, theta, z");
      file.set_attribute(group, "order", trace.order);
    }

    void write_body(Hdf5Writer &file, const std::string &group, const SectorField &body)
    {
      const std::size_t n_lattice = (body.order + 1) * (body.order + 1) * (body.order + 1);
      std::vector<double> points, energy;
      std::vector<std::array<std::complex<double>, 3>> displacement;
      std::vector<unsigned int> material;
      for (const SectorField::Cell &cell : body.cells)
      {
        for (const Point<3> &point : cell.points)
          points.insert(points.end(), {point[0], point[1], point[2]});
        energy.insert(energy.end(), cell.strain_energy.begin(), cell.strain_energy.end());
        displacement.insert(displacement.end(), cell.displacement.begin(), cell.displacement.end());
        material.push_back(cell.material);
      }
      const std::size_t n_cells = body.cells.size();
      file.write(group + "/points", points, {n_cells, n_lattice, 3}, "m",
                 "x, y, z of a lattice of (order + 1)^3 points in each cell");
      write_displacement(file, group, displacement, {n_cells, n_lattice, 3}, "x, y, z");
      file.write(group + "/strain_energy", energy, {n_cells, n_lattice}, "J/m^3",
                 "strain energy per volume at the points, mean over a period");
      file.write(group + "/material", material, {n_cells}, "1",
                 "material of each cell: 1 base, 2 tooth, 3 piezoceramic");
      file.set_attribute(group, "order", body.order);
    }

    void write_wave(Hdf5Writer &file, const CyclicSector &sector, const WaveResult &wave)
    {
      const std::string group = "wave";
      file.set_attribute(group, "nodal_diameter", wave.found.mode.nodal_diameter);
      file.set_attribute(group, "natural_frequency_Hz", wave.found.frequency.value);
      file.set_attribute(group, "natural_frequency_error_Hz", wave.found.frequency.error());
      file.set_attribute(group, "angular_frequency_rad_per_s", wave.angular_frequency);
      file.set_attribute(group, "amplitude_m", wave.amplitude);
      file.set_attribute(group, "relative_error", wave.relative_error());
      for (const Quantity &number : wave.shape)
      {
        file.set_attribute(group + "/shape", number.name, number.value());
        file.set_attribute(group + "/shape", number.name + " error", number.estimate.error());
      }
      file.set_attribute(
          group, "convention",
          std::string(
              "motion is Re(U exp(i omega t)); sector j has exp(-i n j alpha) times the turned "
              "displacement; theta = 0 is the centre of tooth 0; wave travels towards +theta"));
      write_trace(file, "wave/tooth_top",
                  surface_trace(sector, wave.found.mode, Surface::tooth_top));
      write_trace(file, "wave/tooth_foot",
                  surface_trace(sector, wave.found.mode, Surface::tooth_foot));
      write_trace(file, "wave/bottom", surface_trace(sector, wave.found.mode, Surface::bottom));
      write_body(file, "wave/body", sample_sector(sector, wave.found.mode, body_order));
    }
  } // namespace

  namespace
  {
    void write_circuits(Hdf5Writer &file, const MotorCircuits &circuits)
    {
      for (const Phase phase : both_phases)
        for (const Quantity &number : circuits.quantities(phase))
        {
          const std::string group = "circuits/" + name_of(phase),
                            name  = name_with_unit(number.name, number.unit.si);
          file.set_attribute(group, name, number.value());
          file.set_attribute(group, name + " error", number.estimate.error());
        }
    }
  } // namespace

  void write_frequencies(const std::string &path, const std::vector<FoundMode> &modes)
  {
    CsvTable table({"n", "family", "frequency_Hz", "error_Hz", "axial", "in_plane", "torsion",
                    "nodal_circles"});
    for (const FoundMode &found : modes)
      table.add_row({found.mode.nodal_diameter, to_string(found.content.family()),
                     found.frequency.value, found.frequency.error(), found.content.axial,
                     found.content.in_plane, found.content.torsion, found.content.nodal_circles});
    table.write(path);
  }

  void write_ellipses(const std::string &path, const WaveResult &wave)
  {
    std::vector<NamedRow> rows;
    for (const PointResult &result : wave.points)
    {
      rows.push_back({{"point", result.point.name}});
      add_entries(rows.back(), quantities_of(result));
    }
    write_table(path, rows);
  }

  void write_modes_h5(const std::string &path, const Parameters &parameters,
                      const CyclicSector &sector, const std::vector<FoundMode> &modes,
                      const WaveResult *wave, const MotorCircuits *circuits)
  {
    Hdf5Writer file("ringmotor modes", modes_format_version);
    file.set_attribute("/", "motor", parameters.motor.name);
    file.set_attribute("/", "n_waves", parameters.motor.n_waves);
    file.set_attribute("/", "n_teeth", parameters.motor.n_teeth);
    file.set_attribute("/", "polynomial_degree", sector.dofs().get_fe().degree);
    file.set_attribute("/", "parameters", text_of(relevant_for_wave(parameters)));
    write_mode_list(file, modes);
    if (wave != nullptr)
      write_wave(file, sector, *wave);
    if (circuits != nullptr)
      write_circuits(file, *circuits);
    file.save(path);
  }
} // namespace ringmotor
