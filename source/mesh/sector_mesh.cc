// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/sector_mesh.h>

namespace ringmotor
{
  using namespace dealii;

  std::unique_ptr<parallel::shared::Triangulation<3>> empty_triangulation(MPI_Comm communicator)
  {
    using Mesh = parallel::shared::Triangulation<3>;
    return std::make_unique<Mesh>(communicator, Triangulation<3>::MeshSmoothing::none,
                                  /*allow_artificial_cells =*/false,
                                  Mesh::Settings::partition_metis);
  }
} // namespace ringmotor
