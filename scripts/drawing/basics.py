# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all figures share: colours, title and origin, and how they are written."""
import concurrent.futures
import contextlib
import logging
import multiprocessing
import os
import warnings

# Figures are the same for all users: no configuration file is read, neither one that the environment names nor one in the
# current folder, and there is no window.
os.environ.update(MATPLOTLIBRC=os.devnull, MPLBACKEND="agg")
logging.getLogger("matplotlib").setLevel(logging.ERROR)  # that of fonts and folders which another one takes the place of
with contextlib.chdir(os.path.dirname(os.path.abspath(__file__))):
    import matplotlib.pyplot as plt
import numpy as np
from matplotlib import font_manager
from matplotlib.text import Text
from results.case import CaseError

plt.rcParams.update({"font.size": 8.5, "axes.linewidth": 0.7, "svg.hashsalt": "ringmotor"})
# A character without a glyph is told once, see tell_unknown().
warnings.filterwarnings("ignore", message="Glyph .* missing from current font|Matplotlib currently does not support")

# Colours of Okabe and Ito: told apart by colour-blind readers and, by lightness, in grey print.
BLUE, ORANGE, GREEN, PURPLE, SKY, GREY = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#6E6E6E"
METAL = "#E9E9E9"
MICRO, MILLI, KILO = 1e-6, 1e-3, 1e3


def literal(text):
    """What a user or a file system has named: text between two dollars is no formula."""
    return text.replace("$", r"\$")


def start_figure(case, title, size):
    """A figure of a size in inches, with the motor's name in its title and, small, the program that computed it."""
    figure = plt.figure(figsize=size, layout="constrained")
    summary = case.summary
    revision = f" ({summary['git']})" if summary["git"] else ""
    is_long = len(case.motor) + len(title) > size[0] / 0.077  # inches that a letter takes
    figure.suptitle(f"{literal(case.motor)}:{chr(10) if is_long else ' '}{title}", fontsize=10)
    figure.supxlabel(f"ringmotor {summary['version']}{revision}, program {summary['program']}",
                     fontsize=6.5, color=GREY, x=0.995, ha="right")
    return figure


def nice_factor(largest):
    """The largest of 1, 2, 2.5, 5 times a power of ten that does not exceed a number."""
    power = 10.0 ** np.floor(np.log10(largest))
    return max(step * power for step in (1, 2, 2.5, 5) if step * power <= largest * (1 + 1e-9))


def unknown_to(path, characters):
    """Those of a set of characters that a font has no glyph for."""
    try:
        font = font_manager.get_font(path)
    except (OSError, RuntimeError):  # damaged, or of fixed sizes alone, as of emoji
        return characters
    return {one for one in characters if not font.get_char_index(ord(one))}


def give_fonts(figure):
    """Takes installed fonts for the characters which the usual one lacks; the set of those which no font has."""
    texts = figure.findobj(Text)
    usual = font_manager.findfont(font_manager.FontProperties())
    unknown = unknown_to(usual, {one for text in texts for one in text.get_text() if one.isprintable()})
    families = []
    fonts = {font.name: font.fname for font in font_manager.fontManager.ttflist} if unknown else {}
    while unknown and fonts:
        left = {name: unknown_to(path, unknown) for name, path in fonts.items()}
        best = min(left, key=lambda name: (len(left[name]), name))
        if left[best] == unknown:
            break
        families.append(best)
        unknown = left[best]
    for text in texts if families else ():
        text.set_fontfamily([*text.get_fontfamily(), *families])
    return unknown


def tell_unknown(characters):
    if characters:
        print(f"figures: no installed font has {' '.join(sorted(characters))}, which figures show as boxes; install one that has, "
              "such as the Debian package fonts-noto-cjk")


FORMS = {"png": {"Software": None}, "svg": {"Date": None}}  # of the files of a figure, with their metadata


def write(figure, folder, name):
    """Beside the final name, then renamed: a failure leaves no half-written figure. @return see give_fonts()"""
    unknown = give_fonts(figure)
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
    return unknown


def save(figure, folder, name):
    tell_unknown(write(figure, folder, name))


_to_draw = {}  # by name; processes of save_all() have what their parent had


def _save_one(name):
    draw, folder = _to_draw[name]
    return write(draw(), folder, name)


def save_all(figures, folder):
    """Draws and writes figures (name -> function that draws it) on all cores; name -> what went wrong with those that
    cannot be drawn. @throws OSError if the disk refuses them"""
    _to_draw.update({name: (draw, folder) for name, draw in figures.items()})
    n_processes = min(len(os.sched_getaffinity(0)), len(figures))
    if n_processes == 0:
        return {}
    failed, unknown = {}, set()
    with concurrent.futures.ProcessPoolExecutor(n_processes, multiprocessing.get_context("fork")) as pool:
        drawn = {name: pool.submit(_save_one, name) for name in figures}
        for name, future in drawn.items():
            try:
                unknown |= future.result()
            except OSError:
                raise
            except Exception as error:  # of whatever kind: the other figures are drawn
                failed[name] = " ".join(f"{type(error).__name__} {error}".split())
    tell_unknown(unknown)
    return failed


@contextlib.contextmanager
def figures_folder(case_folder, name="figures"):
    """The folder of a case's figures, made if need be; what the disk refuses is told in one line."""
    folder = os.path.join(case_folder, name)
    try:
        os.makedirs(folder, exist_ok=True)
        yield folder
    except OSError as error:
        raise CaseError(f"cannot write into {folder} ({error.strerror or error})") from None
