"""Every command with its arguments; what it does is in a module that is imported when it runs.

Only typer and the standard library are imported here, so that `maestra --help` and shell
completion answer at once.
"""

from enum import Enum
from typing import Annotated, Final

import typer

from maestra import __version__
from maestra.cli import (
    experiment,
    record_commands,
    serve_command,
    teach_commands,
    tell_commands,
)
from maestra.cli.options import ExerciseFile, Json, Lang, LanguageName, Words

_HELP: Final = """Teach a tabletop exercise by showing it, read its rules, judge plays of it.

`-` as a file is standard input or output. Exit code 0: done; 1: the answer is no (a refused
play, rules that are not clear yet); 2: bad input, said in one line on standard error.
"""

app = typer.Typer(
    help=_HELP,
    # Plain help starts in half the time that rich's takes, and reads the same when piped.
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    pretty_exceptions_enable=False,
)
app.add_typer(experiment.app, name="experiment")
app.add_typer(record_commands.store, name="store")
app.add_typer(record_commands.patients, name="patients")
app.command()(record_commands.report)
app.command()(serve_command.serve)


class Learner(Enum):
    """How an exercise is learned: its rules, or the preconditions of the paper's actions."""

    GROUNDED = "grounded"
    COMPILED = "compiled"
    FEWSHOT = "fewshot"


DEFAULT_LEARNER: Final = Learner.FEWSHOT
"""Of `learn` and `demo`."""


class LevelName(Enum):
    """What preconditions may speak of."""

    A = "A"
    B = "B"
    C = "C"


class Engine(Enum):
    """Planners for the learner `compiled`."""

    CLINGO = "clingo"
    FAST_DOWNWARD = "fast-downward"
    MADAGASCAR = "madagascar"


@app.callback(invoke_without_command=True)
def maestra(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Print the version or the help when no command is named."""
    if context.invoked_subcommand is not None and not version:
        return
    from maestra.cli.streams import print_lines

    print_lines([f"maestra {__version__}" if version else context.get_help()])
    raise typer.Exit


@app.command()
def learn(
    demonstrations: Annotated[
        str, typer.Argument(metavar="DEMOS.jsonl", help="What was shown, one a line.")
    ],
    *,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="EXERCISE.json", help="Where to write it.")
    ],
    learner: Annotated[
        Learner | None,
        typer.Option(
            help="Rules from a few demonstrations; or the paper's preconditions, directly or by "
            "planning.  [default: fewshot; grounded with --features or --level]"
        ),
    ] = None,
    features: Annotated[
        str | None,
        typer.Option(
            metavar="NAME,NAME",
            help="The features that preconditions may look at; `features` lists them.",
        ),
    ] = None,
    level: Annotated[
        LevelName | None,
        typer.Option(
            help="What preconditions may look at: relations to the goal row (A), also what "
            "lies there (B), the whole board (C).  [default: A]"
        ),
    ] = None,
    engine: Annotated[
        Engine | None,
        typer.Option(help="The planner for `--learner compiled`.  [default: clingo]"),
    ] = None,
    time_limit: Annotated[
        float, typer.Option(metavar="SECONDS", min=0.001, help="For the planner.")
    ] = 300.0,
    memory_limit: Annotated[
        int, typer.Option(metavar="MB", min=1, help="For the planner.")
    ] = 2048,
    compiled_pddl: Annotated[
        str | None,
        typer.Option(
            "--compiled-pddl", metavar="DIR", help="Also write the planning problem, for audit."
        ),
    ] = None,
    lang: Lang = LanguageName.ENGLISH,
    words: Words = None,
    json: Json = False,
) -> None:
    """Learn an exercise from demonstrations."""
    if learner is None:
        precondition = features is not None or level is not None
        learner = Learner.GROUNDED if precondition else DEFAULT_LEARNER
    if learner is not Learner.COMPILED and (engine is not None or compiled_pddl is not None):
        option = "--compiled-pddl" if engine is None else "--engine"
        raise typer.BadParameter(f"{option} needs --learner compiled")
    if json and output == "-":
        raise typer.BadParameter("--json and --output - both want standard output")
    if learner is Learner.FEWSHOT:
        if features is not None or level is not None:
            option = "--level" if features is None else "--features"
            raise typer.BadParameter(f"{option} needs --learner grounded or compiled")
        from maestra.cli import teaching

        teaching.learn_by_few(demonstrations, output, lang.value, words, as_json=json)
        return
    from maestra.cli import learning

    planning = None
    if learner is Learner.COMPILED:
        name = (engine or Engine.CLINGO).value
        planning = learning.Planning(name, time_limit, memory_limit, compiled_pddl)
    names = None if features is None else tuple(features.split(","))
    chosen = (level or LevelName.A).value
    request = learning.Request(demonstrations, output, names, chosen, planning)
    learning.learn(request, lang.value, words, as_json=json)


app.command()(teach_commands.teach)
app.command()(teach_commands.exam)
app.command()(tell_commands.tell)
app.command()(tell_commands.edit)


@app.command()
def explain(
    exercise: ExerciseFile,
    detail: Annotated[
        bool, typer.Option("--detail", help="Also each action's precondition, as a formula.")
    ] = False,
    lang: Lang = LanguageName.ENGLISH,
    words: Words = None,
    json: Json = False,
) -> None:
    """Say the rules of an exercise in words."""
    from maestra.cli import explaining

    explaining.explain(exercise, lang.value, words, detail=detail, as_json=json)


@app.command()
def moves(
    exercise: ExerciseFile,
    positions: Annotated[
        str, typer.Argument(metavar="POSITIONS.jsonl", help="Plays that are not finished.")
    ],
    json: Json = False,
) -> None:
    """List the right moves in each position."""
    _demand_one_standard_input(exercise, positions)
    from maestra.cli import judging

    _ = json  # it prints nothing else anyway
    judging.moves(exercise, positions)


@app.command()
def judge(
    exercise: ExerciseFile,
    plays: Annotated[str, typer.Argument(metavar="PLAYS.jsonl", help="What was played.")],
    lang: Lang = LanguageName.ENGLISH,
    words: Words = None,
    json: Json = False,
) -> None:
    """Say which moves of each play are right, and why not."""
    _demand_one_standard_input(exercise, plays)
    from maestra.cli import judging

    _ = json
    judging.judge(exercise, plays, lang.value, words)


@app.command()
def export(
    exercise: ExerciseFile,
    pddl: Annotated[
        str, typer.Option("--pddl", metavar="DIR", help="The folder for domain and problem.")
    ],
    play: Annotated[
        str | None,
        typer.Option(metavar="PLAY.jsonl", help="The problem starts where this play stands."),
    ] = None,
    json: Json = False,
) -> None:
    """Write an exercise as a STRIPS domain and problem in PDDL."""
    _demand_one_standard_input(exercise, play)
    from maestra.cli import exporting

    exporting.export(exercise, pddl, play, as_json=json)


@app.command()
def features(
    demonstrations: Annotated[
        str | None,
        typer.Argument(metavar="[DEMOS.jsonl]", help="List those that apply to these."),
    ] = None,
    lang: Lang = LanguageName.ENGLISH,
    json: Json = False,
) -> None:
    """List what `learn --features` takes."""
    from maestra.cli import listing

    listing.features(demonstrations, lang.value, as_json=json)


@app.command()
def demo(
    lang: Annotated[
        LanguageName | None, typer.Option("--lang", help="The language.  [default: yours]")
    ] = None,
    seed: Annotated[
        int | None, typer.Option(metavar="NUMBER", help="Deal the same tokens each time.")
    ] = None,
    learner: Annotated[
        Learner, typer.Option(help="How it learns; by few demonstrations it asks, too.")
    ] = DEFAULT_LEARNER,
) -> None:
    """Teach, or accompany a patient, step by step."""
    if learner is Learner.COMPILED:
        raise typer.BadParameter("--learner: grounded or fewshot, planning takes too long here")
    from maestra.cli import demo_terminal

    demo_terminal.play(
        None if lang is None else lang.value, seed, by_few=learner is Learner.FEWSHOT
    )


@app.command()
def play(
    exercise: ExerciseFile,
    *,
    patient: Annotated[
        str, typer.Option(metavar="PSEUDONYM", help="Who plays; the settings are kept for them.")
    ],
    settings: Annotated[
        str | None, typer.Option(metavar="FILE", help="Settings; else those kept, or defaults.")
    ] = None,
    lang: Annotated[
        LanguageName | None, typer.Option("--lang", help="The language.  [default: theirs]")
    ] = None,
    seed: Annotated[
        int | None, typer.Option(metavar="NUMBER", min=0, help="Deal and speak the same again.")
    ] = None,
    record: Annotated[
        str | None, typer.Option(metavar="FILE", help="Also write the session as JSON Lines.")
    ] = None,
    words: Words = None,
    data: Annotated[
        str | None, typer.Option(metavar="DIR", help="The record: a folder, or a database's URL.")
    ] = None,
    keys: Annotated[str | None, typer.Option(metavar="DIR", help="The record's keys.")] = None,
    speak: Annotated[
        bool, typer.Option("--speak/--quiet", help="Speak aloud, if espeak-ng is there.")
    ] = True,
) -> None:
    """Accompany a patient who plays; exit 1 if not completed."""
    from maestra.cli import playing

    wanted = playing.Wanted(
        exercise,
        patient,
        settings,
        None if lang is None else lang.value,
        seed,
        record,
        data,
        keys,
        speak,
        words,
    )
    if not playing.play(wanted):
        raise typer.Exit(1)


@app.command()
def replay(
    session: Annotated[
        str, typer.Argument(metavar="SESSION", help="A session's file, or its name in the record.")
    ],
    data: Annotated[
        str | None, typer.Option(metavar="DIR", help="The record: a folder, or a database's URL.")
    ] = None,
    keys: Annotated[str | None, typer.Option(metavar="DIR", help="The record's keys.")] = None,
    json: Json = False,
) -> None:
    """Show a session again: what happened, and what the coach did."""
    from maestra.cli import replaying

    replaying.show(session, data, keys, as_json=json)


def _demand_one_standard_input(*files: str | None) -> None:
    if files.count("-") > 1:
        raise typer.BadParameter("only one file can be standard input")
