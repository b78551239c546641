// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/lattice_output.h>
#include <ringmotor/output/ring_files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/pictures/sector_field.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  void write_frequencies(const std::string &path, const std::vector<FoundRingMode> &modes)
  {
    constexpr double degree = numbers::PI / 180.;
    CsvTable table({"n", "family", "frequency_Hz", "error_Hz", "computed_Hz", "share_of_wave",
                    "antinode_degrees", "axial", "in_plane", "torsion", "nodal_circles"});
    for (const FoundRingMode &found : modes)
    {
      const RingContent &wave = found.content;
      table.add_row({wave.n_waves, to_string(wave.content.family()), found.frequency.value,
                     found.frequency.error(), found.computed, wave.share, wave.antinode / degree,
                     wave.content.axial, wave.content.in_plane, wave.content.torsion,
                     wave.content.nodal_circles});
    }
    table.write(path);
  }

  void write_ring_modes(const std::string &path, const CyclicSector &ring,
                        const std::vector<FoundRingMode> &modes, const double amplitude)
  {
    // Where cells are small already, straight ones suffice.
    const unsigned int order = ring.sector_mesh().n_cells() > 4000 ? 1 : 2;
    std::vector<FieldName> names;
    for (std::size_t i = 0; i < modes.size(); ++i)
      names.push_back({"mode_" + std::to_string(i + 1), 3, "m"});
    names.push_back({"material", 1, ""});
    LatticeOutput<3> output(names, order);
    for (std::size_t i = 0; i < modes.size(); ++i)
    {
      const SectorField field = sample_sector(ring, modes[i].mode, order);
      double largest          = 0.;
      for (const SectorField::Cell &cell : field.cells)
        for (const auto &u : cell.displacement)
          largest = std::max(largest, std::hypot(u[0].real(), u[1].real(), u[2].real()));
      if (i == 0)
        for (const SectorField::Cell &cell : field.cells)
        {
          auto &data = output.add_patch(cell.points).data;
          for (std::size_t point = 0; point < cell.points.size(); ++point)
            data(3 * modes.size(), point) = cell.material;
        }
      for (std::size_t c = 0; c < field.cells.size(); ++c)
        for (std::size_t point = 0; point < field.cells[c].points.size(); ++point)
          for (unsigned int d = 0; d < 3; ++d)
            output.patch(c).data(3 * i + d, point) =
                amplitude / largest * field.cells[c].displacement[point][d].real();
    }
    output.write(path);
  }
} // namespace ringmotor
