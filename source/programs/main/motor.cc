// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/programs/program.h>
#include <ringmotor/programs/run_program.h>

int main(int argc, char **argv)
{
  using namespace ringmotor;
  return run_program(argc, argv,
                     {"motor",
                      "Runs stator, contact and losses one after the other.",
                      {stator_program(), contact_program(), losses_program()}});
}
