
# What stands in place of an option: cases where these are asked for, else no options.
_peristat_words() {
    _peristat "$@"
    [[ $2 == -* ]] && return
    case $3 in
        OPTIONS) return ;;
    esac
    local IFS=$'\n' word words=()
    case ${COMP_WORDS[1]} in
        COMMANDS)
            compopt -o filenames 2>/dev/null
            COMPREPLY=($(compgen -f -X '!*.json' -- "$2"; compgen -f -X '!*.jsonc' -- "$2"; compgen -d -- "$2"))
            ;;
        *)
            for word in "${COMPREPLY[@]}"; do
                [[ $word == -* ]] || words+=("$word")
            done
            COMPREPLY=("${words[@]}")
            ;;
    esac
}
complete -F _peristat_words -o bashdefault -o default peristat
