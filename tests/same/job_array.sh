#!/bin/sh
# The commands of doc/reference/parts.md for make, GNU parallel and Slurm, as they stand there but for smaller runs, give
# the files of a single run (JSON: all values) but `run`. Slurm runs as a cluster of this machine alone, with a
# configuration and daemons of its own in a temporary folder, which needs root.
#
#     job_array.sh MURK
set -eu
murk=$(realpath "$1")
top=$(realpath "$(dirname "$0")/../..")
page=$top/doc/reference/parts.md
for program in make parallel sbatch slurmctld slurmd python3; do
    command -v "$program" >/dev/null || { echo "skipped: no $program (Debian: make parallel slurm-wlm)"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: the daemons of Slurm need root"; exit 77; }

work=$(mktemp -d)
daemons=
finish() {
    status=$?
    [ -z "$daemons" ] || kill $daemons 2>/dev/null || true
    wait 2>/dev/null || true
    [ $status = 0 ] || tail -n 20 "$work"/*.log 2>/dev/null || true
    rm -rf "$work"
}
trap finish EXIT
trap 'exit 1' INT TERM
cd "$work"
mkdir bin
ln -s "$murk" bin/murk
PATH=$work/bin:$PATH
export PATH

cat > scene.yaml <<'END'
murk: 1
domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}
geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [3.9, 3.9, 2.9]}}]
media: {fog: {extinction_per_m: 0.3, albedo: 0.9, phase: {hg: 0.8}}}
regions: [{medium: fog}]
lights: [{type: point, position_m: [2, 2, 2.5], power_w: 10}]
photons: {emit: 3000}
sensors:
  types: [{name: node, range_m: 2.2}]
  candidates: {grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 3.5, 2.5], size: [3, 3, 2]}}
  count: 2
END
cat > study.yaml <<'END'
murk_study: 1
base: scene.yaml
axes: {media.fog.albedo: {from: 0.1, to: 0.9, steps: 10}}
outputs: [density, coverage_best, coverage_one_mean, fluence_vdb]
fluence_size: [4, 4, 3]
END

# The indented block of the page that begins with a line like this, for the small study and scene.
block() {
    awk -v first="$1" '!shown && $0 ~ "^    " first {shows = 1}
        shows && !/^    / {shows = 0; shown = 1}
        shows {print substr($0, 5)}' "$page" |
        sed -e 's|scenes/studies/fog-yard.yaml|study.yaml|; s|scenes/smoke-hall.yaml --store 1e5|scene.yaml|'
}

# Compares the files of two folders, JSON without `run`.
same() {
    python3 - "$1" "$2" <<'END'
import json, os, sys

def files_of(folder):
    found = {}
    for at, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(at, name)
            with open(path, "rb") as file:
                data = file.read()
            if name.endswith(".json"):
                fields = json.loads(data)
                fields.pop("run")
                data = json.dumps(fields).encode()
            found[os.path.relpath(path, folder)] = data
    return found

a, b = files_of(sys.argv[1]), files_of(sys.argv[2])
differ = sorted(name for name in a.keys() | b.keys() if a.get(name) != b.get(name))
if differ or not a:
    sys.exit(f"{sys.argv[1]} and {sys.argv[2]} differ: {differ}")
END
}

murk study study.yaml -q -o study
murk trace scene.yaml -q -o light

block 'N := ' > Makefile
make -s -j 2 > make.log
same light out
rm -r out part-*

block 'parallel ' > parallel.sh
sh -eu parallel.sh > parallel.log
same study out
rm -r out part-*
echo "make, GNU parallel: the files of a single run"

# Slurm: one node, this machine.
node=$(hostname -s)
mkdir state spool
cat > slurm.conf <<END
ClusterName=one
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$((20000 + $$ % 20000))
SlurmdPort=$((20001 + $$ % 20000))
AuthType=auth/none
CredType=cred/none
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MailProg=/bin/true
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
SLURM_CONF=$work/slurm.conf
export SLURM_CONF
slurmctld -D > slurmctld.log 2>&1 &
daemons=$!
slurmd -D -N "$node" > slurmd.log 2>&1 &
daemons="$daemons $!"

# Waits until a command succeeds, for a minute.
await() {
    tries=0
    until "$@" > await.log 2>&1; do
        tries=$((tries + 1))
        [ $tries -lt 120 ] || { echo "waited in vain for: $*"; cat await.log; exit 1; }
        sleep .5
    done
}
is_idle() { sinfo -h -o %t | grep -qx idle; }
is_empty() { [ -z "$(squeue -h)" ]; }
await is_idle

block '#!/bin/sh' > part.sh
block 'job=' > submit.sh
sh -eu submit.sh
await is_empty
[ -f out/study.json ] || { cat slurm-*.out; exit 1; }
same study out
# A part that is lost is submitted again, and the merge goes on.
rm -r out part-3
sbatch --array=3 part.sh
await is_empty
[ -f part-3/part.txt ] || { cat slurm-*.out; exit 1; }
rm part-7/part.txt
sbatch --wrap "$(sed -n 's/.*`\(murk merge \$(dirname [^`]*\)`.*/\1/p' "$page")"
await is_empty
same study out
echo "job array: the files of a single run"
