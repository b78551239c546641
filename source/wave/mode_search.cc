// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/wave/mesh_errors.h>
#include <ringmotor/wave/mode_search.h>
#include <ringmotor/wave/shared_modes.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  ModeSearch::ModeSearch(const MaterialTable &materials, const Modes &request, MPI_Comm ranks)
      : materials(materials), request(request), ranks(ranks)
  {
  }

  void ModeSearch::compute(const SectorMesh &mesh, const unsigned int degree)
  {
    model = std::make_unique<CyclicSector>(mesh, materials, degree);
    ModeSolver solver(*model);
    std::vector<Mode> modes = requested_modes(solver);
    missed                  = Utilities::MPI::sum(solver.n_counted() - solver.n_found(), ranks);

    const Sheets sheets(mesh);
    const std::vector<std::vector<double>> indicators = relative_indicators(*model, sheets, modes);

    sheet_error.assign(sheets.n_sheets(), 0.);
    std::map<std::pair<unsigned int, Family>, unsigned int> rank;
    std::vector<FoundMode> now;
    for (unsigned int i = 0; i < modes.size(); ++i)
    {
      const ModeContent content            = mode_content(*model, modes[i]);
      std::vector<FrequencySample> samples = earlier_samples(
          modes[i], content.family(), rank[{modes[i].nodal_diameter, content.family()}]++);
      samples.push_back({degree, modes[i].frequency(),
                         std::accumulate(indicators[i].begin(), indicators[i].end(), 0.)});
      for (unsigned int sheet = 0; sheet < sheets.n_sheets(); ++sheet)
        sheet_error[sheet] += indicators[i][sheet];
      const Estimate estimate = frequency_estimate(samples.back());
      now.push_back({std::move(modes[i]), content, std::move(samples), estimate});
    }
    found = std::move(now);
  }

  std::vector<Mode> ModeSearch::requested_modes(ModeSolver &solver)
  {
    std::vector<unsigned int> mine = share_of_rank(request.nodal_diameters, ranks);
    if (shifts.empty())
    {
      std::map<unsigned int, std::vector<ShiftWindow>> windows;
      for (const unsigned int k : mine)
        windows[k] = solver.windows_above(k, request.n_modes, request.frequency_target);
      shifts = common_shifts(gathered(windows, ranks));
    }
    // In the order of the shifts, as equal ones share a factorisation
    std::stable_sort(mine.begin(), mine.end(),
                     [&](const unsigned int a, const unsigned int b)
                     { return shifts.at(a) < shifts.at(b); });
    std::map<unsigned int, std::vector<Mode>> found_for;
    for (const unsigned int k : mine)
      found_for[k] = modes_below_shift(solver, k);
    found_for = gathered(found_for, *model, ranks);

    std::vector<Mode> modes;
    for (const unsigned int k : request.nodal_diameters)
      std::move(found_for[k].begin(), found_for[k].end(), std::back_inserter(modes));
    return modes;
  }

  std::vector<Mode> ModeSearch::modes_below_shift(ModeSolver &solver, const unsigned int k) const
  {
    const double shift = shifts.at(k);
    std::vector<Mode> modes =
        nearest_elastic(solver.below(k, shift), request.n_modes, request.frequency_target);
    if (modes.size() < request.n_modes)
      throw ComputationError("nodal diameter " + std::to_string(k) + ": only " +
                             std::to_string(modes.size()) + " of " +
                             std::to_string(request.n_modes) + " elastic modes lie below " +
                             std::to_string(std::sqrt(shift) / (2. * numbers::PI)) + " Hz");
    return modes;
  }

  std::vector<FrequencySample> ModeSearch::earlier_samples(const Mode &mode, const Family family,
                                                           const unsigned int rank) const
  {
    unsigned int seen = 0;
    for (const FoundMode &earlier : found)
      if (earlier.mode.nodal_diameter == mode.nodal_diameter &&
          earlier.content.family() == family && seen++ == rank)
        return earlier.samples;
    return {};
  }

  double ModeSearch::worst_relative_error() const
  {
    double worst = 0.;
    for (const FoundMode &mode : found)
      worst = std::max(worst, mode.frequency.relative_error());
    return worst;
  }

  void ModeSearch::refine(SectorMesh &mesh)
  {
    const Sheets sheets(mesh);
    const std::vector<bool> chosen = sheets_with_most_error(mesh, sheets, sheet_error);
    model.reset();
    sheets.refine(mesh, chosen);
  }

  const FoundMode *ModeSearch::working_mode(const unsigned int n_waves) const
  {
    for (const FoundMode &mode : found)
      if (mode.mode.nodal_diameter == n_waves && mode.content.family() == Family::out_of_plane &&
          mode.content.nodal_circles == 0)
        return &mode;
    return nullptr;
  }
} // namespace ringmotor
