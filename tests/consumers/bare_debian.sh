#!/usr/bin/env bash
# A check by hand: does ./run do all the set-up on a Debian 12 that has nothing but its base system?
#
#   tests/consumers/bare_debian.sh FOLDER [MIRROR] [-- ARGUMENT of ./run ...]      as root; needs debootstrap
#
# Makes the base system in FOLDER if it is not there, copies the files of this checkout that git does not ignore, runs
# `./run test` (or what follows --) in it as root, and says how long that took and by how much the system grew.
# FOLDER stays, for a second look; nothing stays mounted.
set -euo pipefail
folder=$(realpath -m -- "${1:?which folder?}")
shift
mirror=
if (($#)) && [[ $1 != -- ]]; then mirror=$1; shift; fi
if (($#)); then shift; fi
if ((!$#)); then set -- test; fi
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)

[[ -e $folder/etc/debian_version ]] || debootstrap --variant=minbase bookworm "$folder" ${mirror:+"$mirror"}
cp /etc/resolv.conf "$folder/etc/"
mkdir -p "$folder/nacre"
git -C "$root" ls-files -z --cached --others --exclude-standard |
    tar -C "$root" --null --files-from - --create | tar -C "$folder/nacre" --extract

megabytes() { du -smx --exclude=./nacre --exclude=./var/cache/apt "$folder" | cut -f1; }
before=$(megabytes)
trap 'umount "$folder/proc" "$folder/dev"' EXIT
mount --bind /proc "$folder/proc"
mount --bind /dev "$folder/dev"
status=0
SECONDS=0
chroot "$folder" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root CI=true /nacre/run "$@" || status=$?
echo "exit code $status, $SECONDS s, $(($(megabytes) - before)) MB more" >&2
exit "$status"
