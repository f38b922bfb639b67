# SPDX-License-Identifier: BSD-3-Clause
#
# ./run sources this file. It runs the benchmarks and the studies.

readonly bench_parts=(tick servo frame bridge probe filters touch parallel)

# run_bench [PART] [ARGS]: runs one part, or all parts. If all parts run, the arguments --benchmark_... are for the
# filters and the others for the tick.
run_bench()
{
  local part=${1:-all} each argument tick=() filters=()
  if [[ " ${bench_parts[*]} " == *" $part "* ]]; then shift; else part=all; fi
  case $part in
    touch | parallel) build_release bench-plugin ;;
    probe) build_release bench-python ;;
    all) build_release bench-all ;;
    *) build_release bench ;;
  esac
  mkdir -p "$build_dir/bench" || exit 1
  if [ "$part" != all ]; then
    bench_part "$part" "$@"
    return
  fi
  for argument in "$@"; do
    if [[ $argument == --benchmark_* ]]; then filters+=("$argument"); else tick+=("$argument"); fi
  done
  for each in "${bench_parts[@]}"; do
    case $each in
      tick) set -- "${tick[@]}" ;;
      filters) set -- "${filters[@]}" ;;
      *) set -- ;;
    esac
    bench_part "$each" "$@" || return
  done
}

# bench_part PART [ARGS]: runs one part. The results are in build/bench, or where --output of the programs says.
bench_part()
{
  local part=$1 results=$build_dir/bench
  local scripts=$source_dir/Testing/Benchmarks
  shift
  case $part in
    tick | servo | frame | bridge) bench_program "${part^}" "$@" ;;
    probe) run_host /usr/bin/python3 "$scripts/probe.py" "$results" "$@" ;;
    filters)
      local program=$release_dir/bin/palpateBenchmarks
      [ -x "$program" ] || die "there is no $program: was Google Benchmark (libbenchmark-dev) found?"
      "$program" --benchmark_out="$results/benchmarks.json" --benchmark_out_format=json "$@" || return
      echo "results in $results/benchmarks.json"
      ;;
    touch) run_host pvpython --dr "$scripts/touch_move.py" "${1:-$results/touch.csv}" ;;
    parallel)
      have mpiexec || die "mpiexec is not installed"
      run_host /usr/bin/python3 "$scripts/parallel.py" mpiexec pvbatch "$(plugin_folder)" "$results" "${1:-2000000}" 2
      ;;
  esac
}

# bench_program Tick|Servo|Frame|Bridge [ARGS]: the frame is drawn off screen, for which OpenGL needs a display. The
# servo thread is also measured while frames are drawn.
bench_program()
{
  local program=$release_dir/bin/palpate$1Benchmark name=${1,} output display=()
  case $name in servo | frame) display=(on_some_display) ;; esac
  [ -x "$program" ] || die "there is no $program: was it left out of the build?"
  shift
  if ! output=$(option_value --output "$@"); then
    output=$build_dir/bench
    set -- --output "$output" "$@"
  fi
  mkdir -p -- "$output" || exit 1
  "${display[@]}" "$program" "$@" || return
  case " $* " in *' --help '* | *' -h '*) return ;; esac
  local plot=$source_dir/Testing/Benchmarks/plot_$name.py
  if [ -e "$plot" ] && /usr/bin/python3 "$plot" "$output/$name.csv" "$output/$name.png"; then
    echo "picture in $output/$name.png"
  fi
}

readonly studies=(paper calculix measured continuity geometry accuracy-speed stability reduction nodule scale
  error coverage)

# run_study NAME [ARGS]: the arguments go to the study's own run.py.
run_study()
{
  local name=${1:-}
  if [[ -z $name || " ${studies[*]} " != *" $name "* ]]; then
    say "there is no study '$name'; there are: ${studies[*]}"
    return 2
  fi
  shift
  case $name in
    calculix) build_release study-calculix ;;
    *) build_release study ;;
  esac
  local output=$build_dir/studies/$name
  mkdir -p "$output" || exit 1
  case $name in
    measured) [ $# -gt 0 ] || set -- "$source_dir/Data/Studies/calculix" "$output/predictions.csv" ;;
    *) set -- --output "$output" "$@" ;; # an --output among the arguments takes precedence
  esac
  run_host /usr/bin/python3 "$source_dir/Testing/Studies/$name/run.py" "$@"
}
