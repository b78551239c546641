# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts take from their surroundings, and what not; each script imports this before anything else of ringmotor's.

The first line of a script, #!/usr/bin/python3 -sE, keeps out modules of a user (~/.local, PYTHONPATH) and other PYTHON*
variables.
"""
import os
import pathlib
import sys
import traceback

# What pip has installed for the whole machine stands before Debian's packages, which fit each other.
sys.path[:] = [folder for folder in sys.path if not folder.startswith("/usr/local/lib/python3")]
# The programs lock the folder of a case, and HDF5 opens no file where the file system has no locks. Read with h5py.
os.environ["HDF5_USE_FILE_LOCKING"] = "FALSE"
if sys.stdout:  # a name may have characters that the terminal lacks
    sys.stdout.reconfigure(errors="replace")


def words_of(error):
    """What an exception that nobody expected tells a user, on one line."""
    if isinstance(error, KeyboardInterrupt):
        return "interrupted"
    said = " ".join(f"{type(error).__name__} {error}".split())
    is_import = any(frame.filename.startswith("<frozen importlib") for frame in traceback.extract_tb(error.__traceback__))
    if not is_import and not isinstance(error, ImportError):
        return f"internal error: {said}"
    if not (sys.flags.no_user_site and sys.flags.ignore_environment):
        return f"{said}; start the script itself, without {os.path.basename(sys.executable)} before it, so that it finds " \
               "Debian's modules"
    if isinstance(error, ModuleNotFoundError):
        return f"{said}; install the Debian package python3-{error.name.partition('.')[0]}, or all by scripts/setup.sh"
    return f"{said}; Debian's packages do not fit each other: install those of scripts/packages.txt again"


def end_in_words(_, error, __):
    if isinstance(error, BrokenPipeError):  # as by "| head": who reads it has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return
    print(f"{pathlib.Path(sys.argv[0]).stem}: {words_of(error)}", file=sys.stderr)


sys.excepthook = end_in_words
