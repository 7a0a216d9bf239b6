// Untested. A job type for Flamenco 3: put it into the folder `scripts` beside Flamenco Manager. A task a shot,
// then one that checks the frames and makes previews. A compiler script reads no files, so the shots' names are a
// setting: paste what `scripts/batch/shots.py names LIST` prints. See docs/farm.md.
const JOB_TYPE = {
  label: "Fluidymation",
  settings: [
    { key: "batch", type: "string", required: true,
      description: "Folder scripts/batch of a clone of fluidymation, as workers see it" },
    { key: "shot_list", type: "string", required: true,
      description: "The shot list, as workers see it" },
    { key: "names", type: "string", required: true,
      description: "Names of the shots to paint, separated by spaces" },
  ],
};

function compileJob(job) {
  const settings = job.settings;
  const check = author.Task("check", "misc");
  check.addCommand(author.Command("exec", {
    exe: settings.batch + "/finish.sh",
    args: ["--previews", settings.shot_list],
  }));
  for (const name of settings.names.split(/\s+/).filter((word) => word.length > 0)) {
    const paint = author.Task("paint-" + name, "misc");
    paint.addCommand(author.Command("exec", {
      exe: settings.batch + "/shots.py",
      args: ["paint", settings.shot_list, name],
    }));
    check.addDependency(paint);
    job.addTask(paint);
  }
  job.addTask(check);
}
