// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/circuit_files.h>
#include <ringmotor/output/table.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  void write_circuits(const std::string &path, const MotorCircuits &circuits)
  {
    std::vector<NamedRow> rows;
    for (const Phase phase : both_phases)
    {
      rows.push_back({{"phase", name_of(phase)}});
      add_entries(rows.back(), circuits.quantities(phase));
    }
    write_table(path, rows);
  }

  void write_admittance(const std::string &path, const MotorCircuits &circuits)
  {
    constexpr unsigned int n_frequencies = 1001;
    const PhaseCircuit one               = circuits.circuit(Phase::a);
    const double low = one.short_circuit_frequency, high = one.open_circuit_frequency(),
                 margin = std::min(0.9 * low,
                                   std::max(4. * (high - low), 20. * low / one.branch.quality));
    CsvTable table({"frequency_Hz", "conductance_A_S", "susceptance_A_S", "conductance_B_S",
                    "susceptance_B_S"});
    for (unsigned int i = 0; i < n_frequencies; ++i)
    {
      // Denser around the resonance, in the middle
      const double place = 2. * i / (n_frequencies - 1.) - 1.,
                   f     = low + margin * std::pow(place, 3);
      std::vector<CsvTable::Entry> row{f};
      for (const Phase phase : both_phases)
      {
        const std::complex<double> admittance = circuits.circuit(phase).admittance(f);
        row.insert(row.end(), {admittance.real(), admittance.imag()});
      }
      table.add_row(row);
    }
    table.write(path);
  }

  void write_electrodes(const std::string &path, const ElectrodeLayout &layout)
  {
    CsvTable table({"phase", "begin_deg", "end_deg", "poling"});
    for (const Phase phase : both_phases)
      for (const ElectrodeLayout::Arc &arc : layout.arcs(phase))
        table.add_row({name_of(phase), arc.begin / units::angle.size, arc.end / units::angle.size,
                       arc.sign > 0. ? "up" : "down"});
    table.write(path);
  }

  void write_excitation(const std::string &path, const ElectrodeLayout &layout,
                        const unsigned int largest_n)
  {
    CsvTable table({"n", "phase_A", "phase_B"});
    for (unsigned int n = 0; n <= largest_n; ++n)
      table.add_row({n, layout.excitation(Phase::a, n), layout.excitation(Phase::b, n)});
    table.write(path);
  }
} // namespace ringmotor
