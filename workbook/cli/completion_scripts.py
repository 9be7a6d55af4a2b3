"""The scripts of `workbook completion`: everything they offer is written into them, so that Tab answers at once.

Each script goes through the words before the cursor once, to find the command and how many of its places are filled.
"""

from collections.abc import Iterable, Mapping, Sequence

from workbook.cli.command_tree import FILES, Command, CommandOption, Wanted

Words = Mapping[str, Sequence[str]]
"""The words of each kind: the exercises and the topics."""

_BASH = """\
_workbook() {
    local cur=${COMP_WORDS[COMP_CWORD]} command="" places=0 skip="" index word words=""
    for ((index = 1; index < COMP_CWORD; index++)); do
        word=${COMP_WORDS[index]}
        if [[ -n $skip ]]; then
            skip=""
            continue
        fi
        case "$command $word" in
            @commands@) command="${command:+$command }$word" places=0 ;;
            @taking@) skip="$word" ;;
            *" -"*) ;;
            *) places=$((places + 1)) ;;
        esac
    done
    if [[ -n $skip ]]; then
        case "$command $skip" in
@values@
        esac
    elif [[ $cur == -* ]]; then
        case "$command" in
@options@
        esac
    else
        case "$command/$places" in
@places@
        esac
    fi
    if [[ $words == "@files@" ]]; then
        mapfile -t COMPREPLY < <(compgen -f -- "$cur")
        compopt -o filenames 2>/dev/null
    else
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
    fi
}
complete -F _workbook workbook
"""

_ZSH = """\
#compdef workbook
_workbook() {
    local command="" skip="" wanted="" word
    local -i places=0 index
    for ((index = 2; index < CURRENT; index++)); do
        word=${words[index]}
        if [[ -n $skip ]]; then
            skip=""
            continue
        fi
        case "$command $word" in
            @commands@) command="${command:+$command }$word" places=0 ;;
            @taking@) skip="$word" ;;
            *" -"*) ;;
            *) places+=1 ;;
        esac
    done
    local -a offers
    if [[ -n $skip ]]; then
        case "$command $skip" in
@values@
        esac
    elif [[ ${words[CURRENT]} == -* ]]; then
        case "$command" in
@options@
        esac
    else
        case "$command/$places" in
@places@
        esac
    fi
    if [[ ${offers[1]} == "@files@" ]]; then
        _files
    elif ((${#offers})); then
        _describe -t words "" offers
    fi
}
if [[ ${funcstack[1]} == _workbook ]]; then
    _workbook "$@"
else
    compdef _workbook workbook
fi
"""

_FISH = """\
function __workbook_at --argument-names wanted
    set -l command
    set -l places 0
    set -l skip ""
    set -l typed (commandline -opc)
    for word in $typed[2..-1]
        if test -n "$skip"
            set skip ""
            continue
        end
        switch (string join " " -- $command $word)
            case @commands@
                set -a command $word
                set places 0
            case @taking@
                set skip $word
            case "*"
                string match -q -- "-*" $word; or set places (math $places + 1)
        end
    end
    set -l here (string join " " -- $command)
    test "$here" = "$wanted"; and return
    test -z "$skip"; and test "$here/$places" = "$wanted"
end
complete -c workbook -f
"""


def bash(commands: Sequence[Command], words: Words) -> str:
    """The script for bash."""

    def line(pattern: str, offered: Iterable[str]) -> str:
        return f'            "{pattern}") words="{" ".join(offered)}" ;;'

    values, options, places = _cases(commands, words)
    return _filled(
        _BASH,
        commands,
        values="\n".join(line(pattern, offered) for pattern, offered in values),
        options="\n".join(line(pattern, [one.name for one in offered]) for pattern, offered in options),
        places="\n".join(line(pattern, offered) for pattern, offered in places),
    )


def zsh(commands: Sequence[Command], words: Words) -> str:
    """The script for zsh, which shows what each command and option does."""

    def line(pattern: str, offered: Iterable[str]) -> str:
        quoted = " ".join(f"'{offer}'" for offer in offered)
        return f'            "{pattern}") offers=({quoted}) ;;'

    values, options, places = _cases(commands, words)
    told = {" ".join(one.words) + "/0": one.below for one in commands if one.below}
    return _filled(
        _ZSH,
        commands,
        values="\n".join(line(pattern, offered) for pattern, offered in values),
        options="\n".join(
            line(pattern, [f"{one.name}:{one.text}" for one in offered]) for pattern, offered in options
        ),
        places="\n".join(
            line(pattern, [_told(offer, told.get(pattern, {})) for offer in offered])
            for pattern, offered in places
        ),
    )


def fish(commands: Sequence[Command], words: Words) -> str:
    """The script for fish, which shows what each command and option does."""
    lines = []
    for command in commands:
        here = " ".join(command.words)
        for option in command.options:
            value = "" if option.value is None else f" -x -a '{' '.join(_offered(option.value, words))}'"
            if option.value is not None and option.value.kind == FILES:
                value = " -r -F"
            flag = f"-l {option.name[2:]}" if option.name.startswith("--") else f"-s {option.name[1:]}"
            lines.append(
                f"complete -c workbook -n '__workbook_at \"{here}\"' {flag}{value} -d '{option.text}'"
            )
        for name, text in command.below.items():
            lines.append(f"complete -c workbook -n '__workbook_at \"{here}/0\"' -a {name} -d '{text}'")
        for number, place in enumerate(command.places):
            offered = _offered(place, words)
            if offered:
                offer = "-F" if place.kind == FILES else f"-a '{' '.join(offered)}'"
                lines.append(f"complete -c workbook -n '__workbook_at \"{here}/{number}\"' {offer}")
    return _filled(_FISH, commands, separator=" ") + "\n".join(lines) + "\n"


SHELLS = {"bash": bash, "zsh": zsh, "fish": fish}

_Cases = list[tuple[str, Sequence[str]]]


def _told(offer: str, texts: Mapping[str, str]) -> str:
    return f"{offer}:{texts[offer]}" if offer in texts else offer


def _cases(
    commands: Sequence[Command], words: Words
) -> tuple[_Cases, list[tuple[str, Sequence[CommandOption]]], _Cases]:
    """What to offer: for the value of an option, for options, and for a place, each under its pattern."""
    values, options, places = _Cases(), list[tuple[str, Sequence[CommandOption]]](), _Cases()
    for command in commands:
        here = " ".join(command.words)
        options.append((here, command.options))
        values += [
            (f"{here} {option.name}", _offered(option.value, words))
            for option in command.options
            if option.value is not None
        ]
        if command.below:
            places.append((f"{here}/0", tuple(command.below)))
        places += [(f"{here}/{number}", _offered(one, words)) for number, one in enumerate(command.places)]
    return [one for one in values if one[1]], options, [one for one in places if one[1]]


def _offered(wanted: Wanted, words: Words) -> tuple[str, ...]:
    if wanted.kind == FILES:
        return (_FILES_MARK,)
    return wanted.words or tuple(words.get(wanted.kind, ()))


_FILES_MARK = "@files"


def _filled(script: str, commands: Sequence[Command], separator: str = " | ", **parts: str) -> str:
    """A script with the patterns that find the command, and the given parts, put in."""
    known = [" ".join(one.words) for one in commands if one.words]
    taking = [
        f"{' '.join(one.words)} {option.name}"
        for one in commands
        for option in one.options
        if option.value is not None
    ]
    blank = "" if separator == " " else " "
    parts["commands"] = separator.join(f'"{name if " " in name else blank + name}"' for name in known)
    parts["taking"] = separator.join(f'"{name}"' for name in taking)
    parts["files"] = _FILES_MARK
    for name, text in parts.items():
        script = script.replace(f"@{name}@", text)
    return script
