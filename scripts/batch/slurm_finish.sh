#!/usr/bin/env bash
# The job that follows the painting of a shot list; scripts/batch/slurm.sh submits it.
# Usage: sbatch ... slurm_finish.sh BATCH_DIR LIST
exec "$1/finish.sh" --previews "$2"
