# SPDX-License-Identifier: LGPL-2.1-or-later
"""Looks for the motor with most of a quantity within limits: coarse targets first, finer ones for those that may win."""
import hashlib
import json
import os
import warnings
from dataclasses import dataclass

import optuna
from case import CaseError
from goals import is_of_wave, quantity_of
from sweep_table import row_of

COARSE = 0.1  # Accuracy/Contact target of the first motors
FINER = 0.3  # of one stage over that before
MOST_CANDIDATES = 12  # that one stage hands on to the next
NO_MOTOR = 1e6  # excess of a motor that was refused or failed


@dataclass(frozen=True)
class Aim:
    """The quantity to be maximised, or minimised if sign is -1, and the limits of others."""

    name: str
    sign: int
    limits: tuple

    def names(self):
        return [self.name, *(one.name for one in self.limits)]

    def is_of_wave(self):
        return all(map(is_of_wave, self.names()))

    def of(self, row):
        """Value, the larger the better, and error bar."""
        quantity = quantity_of(row, self.name)
        return self.sign * quantity.value, quantity.error

    def excesses(self, row):
        """Of each limit, negative inside; first whether there is a motor at all."""
        if row.outcome != "certified":
            return [NO_MOTOR] * (1 + len(self.limits))
        for one in self.limits:
            quantity_of(row, one.name)
        return [-1., *(one.excess(row) for one in self.limits)]

    def is_possible(self, row):
        """Whether it may keep all limits, within their error bars."""
        return row.outcome == "certified" and all(one.may_hold(row) for one in self.limits)


def open_study(family, aim, all_varied, seed):
    """The study of the same question that is in the folder, or a new one. Its motors that were being computed when it
    was interrupted are computed first."""
    os.makedirs(family.output, exist_ok=True)
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
    question = json.dumps([family.basis, family.settings, str(aim), str(all_varied), seed], sort_keys=True)
    sampler = optuna.samplers.TPESampler(seed=seed, multivariate=True, constant_liar=True, n_startup_trials=4 * len(all_varied) + 4,
                                         constraints_func=lambda trial: trial.user_attrs["excesses"])
    study = optuna.create_study(storage=f"sqlite:///{family.output}/optuna.db", sampler=sampler, direction="maximize",
                                study_name=hashlib.sha256(question.encode()).hexdigest()[:12], load_if_exists=True)
    for trial in study.get_trials(deepcopy=False, states=[optuna.trial.TrialState.RUNNING]):
        study.tell(trial.number, state=optuna.trial.TrialState.FAIL)
        study.enqueue_trial(trial.params)
    return study


def draw(trial, one):
    """A value of an entry that varies, as text."""
    if one.values and one.low != one.low:
        return trial.suggest_categorical(one.entry, one.values)
    return one.at(round(trial.suggest_float(one.entry, 0., 1.), 4))  # a ten thousandth of the range is near enough


def explore(engine, family, all_varied, aim, study, n_trials, coarse):
    """Motors at a coarse target, as the sampler draws them; rows of all."""
    complete = [optuna.trial.TrialState.COMPLETE]
    n_started = len(study.get_trials(deepcopy=False, states=complete))
    if n_started:
        print(f"{n_started} motors are known already")
    running, rows = {}, {}  # trials, which may ask for the same motor, and what is found, by folder

    def finish(row):
        for trial in running.pop(row.folder):
            trial.set_user_attr("excesses", aim.excesses(row))
            trial.set_user_attr("entries", row.varied)
            study.tell(trial, aim.of(row)[0] if row.outcome == "certified" else 0.)

    while n_started < n_trials or running:
        while n_started < n_trials and len(running) < engine.n_workers():
            trial = study.ask()
            n_started += 1
            motor = family.motor({one.entry: draw(trial, one) for one in all_varied}, aim.is_of_wave(), **coarse)
            running.setdefault(motor.task.folder, []).append(trial)
            if motor.task.folder in rows:
                finish(rows[motor.task.folder])
            else:
                engine.submit(motor)
        if running:
            row = row_of(*engine.next_done())
            rows[row.folder] = row
            finish(row)
            tell(n_started - sum(map(len, running.values())), n_trials, row, aim)
    # Motors of an interrupted study are in their folders.
    return rows_of(engine, [family.motor(trial.user_attrs["entries"], aim.is_of_wave(), **coarse)
                            for trial in study.get_trials(deepcopy=False, states=complete)])


def tell(number, count, row, aim):
    if row.outcome == "certified":
        quantity = row.quantities[aim.name]
        said = f"{aim.name} = {quantity.value:.5g} +- {quantity.error:.2g} {quantity.unit}".rstrip()
        broken = [str(one) for one in aim.limits if not one.may_hold(row)]
        said += f"; not {', '.join(broken)}" if broken else ""
    else:
        said = f"{row.outcome}: {row.message}"
    print(f"{number} of {count}: {row.inputs()}: {said}", flush=True)


def rows_of(engine, motors):
    by_folder = {motor.task.folder: motor for motor in motors}
    for motor in by_folder.values():
        engine.submit(motor)
    return [row_of(*engine.next_done()) for _ in by_folder]


def contenders(rows, aim):
    """Those that may be the best, from the best value on: no other one is better by more than both error bars."""
    possible = sorted((row for row in rows if aim.is_possible(row)), key=lambda row: -aim.of(row)[0])
    if not possible:
        return []
    least = max(value - error for value, error in map(aim.of, possible))
    return [row for row in possible if sum(aim.of(row)) >= least]


def stages(own_target):
    """Contact targets from the coarse one to that of the file."""
    targets = [max(COARSE, own_target)]
    while targets[-1] > own_target * 1.001:
        targets.append(max(own_target, targets[-1] * FINER))
    return targets


def optimise(engine, family, all_varied, aim, loading, own_target, n_trials, seed):
    """All rows of the search, each stage's, and the contenders of the last one, best first. @throws CaseError if no
    motor keeps the limits"""
    all_rows, rows = [], []
    for target in stages(own_target):
        settings = {**loading, "Accuracy/Contact target": f"{target:g}"}
        if not rows:
            print(f"Contact target = {target:g}: {n_trials} motors")
            study = open_study(family, aim, all_varied, seed)
            rows = explore(engine, family, all_varied, aim, study, n_trials, settings)
        else:
            print(f"Contact target = {target:g}: {len(chosen)} motors that may be the best")
            rows = rows_of(engine, [family.motor(row.varied, aim.is_of_wave(), **settings) for row in chosen])
            for number, row in enumerate(rows, 1):
                tell(number, len(rows), row, aim)
        all_rows += [(target, row) for row in rows]
        chosen = contenders(rows, aim)
        if not chosen:
            kept = f"keeps {', '.join(map(str, aim.limits))}" if aim.limits else "is certified"
            raise CaseError(f"none of {len(rows)} motors {kept}: widen the ranges or the limits, or ask for more with --trials")
        if len(chosen) > MOST_CANDIDATES:
            print(f"{len(chosen)} motors may be the best; the first {MOST_CANDIDATES} of them go on")
            chosen = chosen[:MOST_CANDIDATES]
    return all_rows, chosen
