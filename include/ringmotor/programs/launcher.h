// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

namespace ringmotor
{
  /**
   * To be called before MPI starts: a program started without mpirun needs no network, and not
   * looking for one saves a third of a second; nor does it need a folder for its session, which
   * it would share with others that run at the same time. Ranks of one computer need no network
   * either, which saves more than a second.
   */
  void spare_the_network_search();

  /**
   * Whether this is one of several copies that do not find each other, as the mpirun (srun, ...)
   * that has started them belongs to another MPI than the programs: each would compute the same.
   * To be called after MPI has started.
   * @return what to tell the user; empty in all copies but the first one
   */
  std::optional<std::string> complaint_about_launcher();
} // namespace ringmotor
