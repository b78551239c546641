# SPDX-License-Identifier: LGPL-2.1-or-later
"""Looks for the motor with most of a quantity within limits: coarse targets first, finer ones for those that may win."""
import hashlib
import json
import os
import sqlite3
import warnings

import optuna
from motors.sweep_table import row_of
from results.case import CaseError
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.pool import NullPool

COARSE = 0.1  # Accuracy/Contact target of the first motors
FINER = 0.3  # of one stage over that before
MOST_CANDIDATES = 12  # that one stage hands on to the next


def opened(path, seed, n_varied, name):
    """The study of this name in a database. @throws CaseError if it is damaged or of a newer Optuna"""
    sampler = optuna.samplers.TPESampler(seed=seed, multivariate=True, constant_liar=True, n_startup_trials=4 * n_varied + 4,
                                         constraints_func=lambda trial: trial.user_attrs["excesses"])
    try:
        # By a function: in the address of a database, some letters of a path have a meaning.
        storage = optuna.storages.RDBStorage("sqlite://", engine_kwargs={"creator": lambda: sqlite3.connect(path),
                                                                         "poolclass": NullPool})
        return optuna.create_study(storage=storage, sampler=sampler, direction="maximize", study_name=name,
                                   load_if_exists=True)
    except Exception as error:  # of whatever kind: the file may be anything
        raise unusable(path, error) from None


def unusable(path, error):
    return CaseError(f"{path} cannot be used ({' '.join(str(error).split())[:160]}): remove it and start again; the motors "
                     "that have been computed stay known")


def open_study(family, aim, all_varied, seed):
    """The study of the same question that is in the folder, or a new one. Its motors that were being computed when it
    was interrupted are computed first."""
    os.makedirs(family.output, exist_ok=True)
    optuna.logging.set_verbosity(optuna.logging.CRITICAL)
    warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
    question = json.dumps([family.identity, str(aim), str(all_varied), seed], sort_keys=True)
    study = opened(database_of(family), seed, len(all_varied), hashlib.sha256(question.encode()).hexdigest()[:12])
    for trial in study.get_trials(deepcopy=False, states=[optuna.trial.TrialState.RUNNING]):
        study.tell(trial.number, state=optuna.trial.TrialState.FAIL)
        study.enqueue_trial(trial.params)
    return study


def database_of(family):
    return os.path.join(family.output, "optuna.db")


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
    running, done = {}, {}  # trials, and rows, by their motors
    while n_started < n_trials or running:
        while n_started < n_trials and len(running) < engine.n_workers():
            trial = study.ask()
            n_started += 1
            motor = family.motor({one.entry: draw(trial, one) for one in all_varied}, **coarse)
            running[motor] = trial
            engine.submit(motor)
        motor, outcome = engine.next_done()
        trial, row = running.pop(motor), row_of(motor, outcome)
        done[motor.key] = row
        trial.set_user_attr("excesses", aim.excesses(row))
        trial.set_user_attr("entries", row.varied)
        study.tell(trial, aim.of(row)[0] if row.outcome == "certified" else 0.)
        tell(n_started - len(running), n_trials, row, aim)
    # Motors of an interrupted study are in their folders.
    motors = [family.motor(trial.user_attrs["entries"], **coarse)
              for trial in study.get_trials(deepcopy=False, states=complete)]
    return [*done.values(), *rows_of(engine, [motor for motor in motors if motor.key not in done])]


def tell(number, count, row, aim):
    if row.outcome == "certified":
        said = f"{aim.name} = {row.quantities[aim.name]}"
        broken = [str(one) for one in aim.limits if not one.may_hold(row)]
        said += f"; not {', '.join(broken)}" if broken else ""
    else:
        said = f"{row.outcome}: {row.message}"
    print(f"{number} of {count}: {row.inputs()}: {said}", flush=True)


def rows_of(engine, motors):
    """Of each motor one, though the sampler may have drawn it twice."""
    different = {motor.key: motor for motor in motors}.values()
    for motor in different:
        engine.submit(motor)
    return [row_of(*engine.next_done()) for _ in different]


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
            try:
                study = open_study(family, aim, all_varied, seed)
                rows = explore(engine, family, all_varied, aim, study, n_trials, settings)
            except (SQLAlchemyError, optuna.exceptions.OptunaError) as error:
                raise unusable(database_of(family), error) from None
        else:
            print(f"Contact target = {target:g}: {len(chosen)} motors that may be the best")
            rows = rows_of(engine, [family.motor(row.varied, **settings) for row in chosen])
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
