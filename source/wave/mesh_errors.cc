// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/refinement_indicator.h>
#include <ringmotor/wave/mesh_errors.h>

#include <algorithm>
#include <numeric>

namespace ringmotor
{
  std::vector<std::vector<double>> relative_indicators(const CyclicSector &sector,
                                                       const Sheets &sheets,
                                                       const std::vector<Mode> &modes)
  {
    std::vector<const SectorMotion *> motions;
    for (const Mode &mode : modes)
      motions.push_back(&mode.motion);
    std::vector<std::vector<double>> indicators =
        sector.dofs().get_fe().degree > 1
            ? sheet_indicators(sector, sheets, motions)
            : std::vector(modes.size(), std::vector(sheets.n_sheets(), 0.));
    for (unsigned int i = 0; i < modes.size(); ++i)
      for (double &indicator : indicators[i])
        indicator /= modes[i].eigenvalue;
    return indicators;
  }

  std::vector<bool> sheets_with_most_error(const SectorMesh &mesh, const Sheets &sheets,
                                           const std::vector<double> &error)
  {
    std::vector<double> n_cells(sheets.n_sheets(), 0.);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (unsigned int direction = 0; direction < 3; ++direction)
        n_cells[sheets.sheet(*cell, direction)] += 1.;
    std::vector<unsigned int> order(sheets.n_sheets());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](const unsigned int a, const unsigned int b)
              { return error[a] / n_cells[a] > error[b] / n_cells[b]; });
    const double total = std::accumulate(error.begin(), error.end(), 0.);
    std::vector<bool> chosen(sheets.n_sheets(), false);
    double covered = 0.;
    for (const unsigned int sheet : order)
      if (covered < 0.6 * total)
      {
        chosen[sheet] = true;
        covered += error[sheet];
      }
    return chosen;
  }
} // namespace ringmotor
