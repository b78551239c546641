# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all figures share: colours, title and origin, and how they are written."""
import contextlib
import multiprocessing
import os
import sys

try:
    import matplotlib
    import numpy as np

    from case import CaseError

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    sys.exit(f"figures: {error}; scripts/setup.sh installs what is missing, run with /usr/bin/python3")

plt.rcParams.update({"font.size": 8.5, "axes.linewidth": 0.7, "svg.hashsalt": "ringmotor"})

# Colours of Okabe and Ito: told apart by colour-blind readers and, by lightness, in grey print.
BLUE, ORANGE, GREEN, PURPLE, SKY, GREY = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#6E6E6E"
METAL = "#E9E9E9"
MICRO, MILLI, KILO = 1e-6, 1e-3, 1e3


def start_figure(case, title, size):
    """A figure of a size in inches, with the motor's name in its title and, small, the program that computed it."""
    figure = plt.figure(figsize=size, layout="constrained")
    summary = case.summary
    revision = f" ({summary['git']})" if summary["git"] else ""
    motor = case.motor.replace("$", r"\$")  # else text between two of them is set as a formula
    is_long = len(motor) + len(title) > size[0] / 0.077  # inches that a letter takes
    figure.suptitle(f"{motor}:{chr(10) if is_long else ' '}{title}", fontsize=10)
    figure.supxlabel(f"ringmotor {summary['version']}{revision}, program {summary['program']}",
                     fontsize=6.5, color=GREY, x=0.995, ha="right")
    return figure


def nice_factor(largest):
    """The largest of 1, 2, 2.5, 5 times a power of ten that does not exceed a number."""
    power = 10.0 ** np.floor(np.log10(largest))
    return max(step * power for step in (1, 2, 2.5, 5) if step * power <= largest * (1 + 1e-9))


FORMS = {"png": {"Software": None}, "svg": {"Date": None}}  # of the files of a figure, with their metadata


def save(figure, folder, name):
    """Writes beside the final name and renames: a failure leaves no half-written figure."""
    for kind, metadata in FORMS.items():
        path = os.path.join(folder, f"{name}.{kind}")
        part = path + ".part"
        try:
            figure.savefig(part, format=kind, dpi=220, metadata=metadata)
            os.replace(part, path)
        finally:
            if os.path.exists(part):
                os.remove(part)
        figure.set_layout_engine("none")  # both kinds have the same layout: finding it takes half of the time
    plt.close(figure)


_to_draw = {}  # by name; processes of save_all() have what their parent had


def _save_one(name):
    draw, folder = _to_draw[name]
    save(draw(), folder, name)


def save_all(figures, folder):
    """Draws and writes figures (name -> function that draws it) on all cores."""
    _to_draw.update({name: (draw, folder) for name, draw in figures.items()})
    n_processes = min(len(os.sched_getaffinity(0)), len(figures))
    if n_processes == 0:
        return
    with multiprocessing.get_context("fork").Pool(n_processes) as pool:
        for _ in pool.imap_unordered(_save_one, figures):
            pass


@contextlib.contextmanager
def figures_folder(case_folder):
    """The folder of a case's figures, made if need be; what the disk refuses is told in one line."""
    folder = os.path.join(case_folder, "figures")
    try:
        os.makedirs(folder, exist_ok=True)
        yield folder
    except OSError as error:
        raise CaseError(f"cannot write into {folder} ({error.strerror or error})") from None
