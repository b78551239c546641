// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/programs/program.h>
#include <ringmotor/programs/run_program.h>

int main(int argc, char **argv)
{
  return ringmotor::run_program(argc, argv, {ringmotor::losses_program()});
}
