# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/common.sh"

expectExit 0 track demo --out run --frames 0:60 --seed 1
[[ ! -s err.txt ]] || fail "not quiet when piped: $(cat err.txt)"
expectText run/trajectory.csv method dewpoint seed version \
  'time_s,frame,target,x_m,y_m,z_m,' ',ess,cameras,valid' ',best_x_m,best_y_m,best_z_m'
# 60 frames, one target.
[[ $(rowCount run/trajectory.csv) == 60 ]] || fail "$(rowCount run/trajectory.csv) rows, not 60"
expectText run/run.json '"frames"' '"seconds"'

expectExit 0 evaluate run/trajectory.csv run/truth.csv
expectText out.txt RMSE mm
expectExit 0 evaluate run/trajectory.csv run/truth.csv --json
expectText out.txt '"rmse' '"unit"'

# A second run replaces the first; particles and parameters reach the filter and the header.
expectExit 0 track demo --method barrera --out run --frames 0:5 --particles 50 --set motion_sigma=0.02
[[ $(rowCount run/trajectory.csv) == 5 ]] || fail "the second run did not replace the first"
expectText run/trajectory.csv 50 0.02

# When and why the target was held, on request only.
[[ ! -e run/reasons.csv ]] || fail "reasons.csv was not asked for"
expectExit 0 track demo --out why --frames 0:30 --reasons
expectText why/reasons.csv time_s,frame,target,state,reason ,held,

# Only within a box: the ball of the demo is in the first, and not in the second.
expectExit 0 track demo --out within --frames 0:20 --volume 0.2,0.2,-0.2,0.8,0.8,0.6
expectText within/trajectory.csv volume_of_interest '0.2 0.2 -0.2 to 0.8 0.8 0.6 m'
expectText within/run.json volume_of_interest
holds() {
  awk -F, '/^time_s/ { for (k = 1; k <= NF; ++k) if ($k == "valid") valid = k; next }
           !/^#/ && $valid == 1 { ++rows } END { exit rows == 0 }' "$1"
}
holds within/trajectory.csv || fail "the ball within the volume was not found"
expectExit 0 track demo --out beside --frames 0:20 --volume -0.9,-0.9,-0.2,-0.2,-0.2,0.6
! holds beside/trajectory.csv || fail "something outside the volume was found"
# A project may say where the target is at a frame.
cat >corrected.toml <<'END'
format = 2
method = "barrera"
scene = "demo"
[[target]]
name = "ball"
hue = [300, 335]
[[correction]]
frame = 3
target = 1
position = [0.5, 0.25, 0.125]
covariance = [1e-4, 0, 0, 1e-4, 0, 1e-4]
[[correction.click]]
camera = 2
pixel = [10, 20]
END
expectExit 0 track corrected.toml --out corrected --frames 0:6
expectText corrected/trajectory.csv ',best_z_m,corrected' ',3,ball,0.5,0.25,0.125,'
[[ $(grep -c ',1$' corrected/trajectory.csv) == 1 ]] || fail "not one row is marked"
expectText corrected/run.json '"corrections"' '"frame": 3' '"clicks"'
expectExit 0 export corrected --format jsonl --out corrected.jsonl
expectText corrected.jsonl '"corrected":true'
sed -i 's/target = 1/target = 2/' corrected.toml
expectExit $kBadInput track corrected.toml --out corrected --frames 0:6
expectSentence corrected.toml 'correction 1.target'

# A truth in millimeters is noticed, and read as such.
awk -F, -v OFS=, 'BEGIN { x = y = z = 0 } /^#/ { print; next }
  !x { for (i = 1; i <= NF; ++i) { if ($i == "x_m") x = i; if ($i == "y_m") y = i; if ($i == "z_m") z = i } print; next }
  { $x *= 1000; $y *= 1000; $z *= 1000; print }' why/truth.csv >millimeters.csv
expectExit 0 evaluate why/trajectory.csv millimeters.csv
expectText err.txt millimeters.csv '--truth-unit mm'
expectExit 0 evaluate why/trajectory.csv millimeters.csv --truth-unit mm
expectText out.txt 'converged          after'
[[ ! -s err.txt ]] || fail "a note in spite of --truth-unit: $(cat err.txt)"
expectExit $kUsage evaluate why/trajectory.csv millimeters.csv --truth-unit parsec
