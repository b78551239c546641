// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/body_vtu.h>

namespace ringmotor
{
  void write_body(const std::string &path, const RingBody &body,
                  const std::vector<PointField> &fields)
  {
    constexpr std::array<unsigned int, 8> vtk_order{{0, 1, 3, 2, 4, 5, 7, 6}};
    std::vector<std::int32_t> cells;
    for (const auto &cell : body.cells())
      for (const unsigned int v : vtk_order)
        cells.push_back(static_cast<std::int32_t>(cell[v]));
    VtuGrid(body.points(), cells, vtk_order.size(), VtuCell::hexahedron).write(path, fields);
  }
} // namespace ringmotor
