package org.phrenic.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.cli.report.FileInfo;
import org.phrenic.cli.report.ReportingCommand;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code phrenic info}: prints the contents of files. */
@Command(
        name = "info",
        description = "Say what meshes, label volumes, scenarios and thorax folders hold.",
        footer = {
            "",
            "Examples:",
            "  phrenic info diaphragm.ply liver.stl",
            "  phrenic info scenario.yaml",
            "  phrenic info segmentation.nii.gz",
            "  phrenic info my-thorax --json"
        })
final class InfoCommand extends ReportingCommand {
    @Parameters(
            arity = "1..*",
            paramLabel = "FILE",
            description =
                    "A mesh (stl, obj, ply, vtk, vtp), a label volume (nii, nii.gz, nrrd, nhdr, mha, mhd, dcm), a "
                            + "scenario (yaml) or a folder of meshes.")
    private List<Path> files;

    @Override
    public Integer call() {
        List<Map<String, Object>> all = files.stream().map(FileInfo::of).toList();
        print(Map.of("files", all), () -> all.stream().map(FileInfo::text).collect(Collectors.joining("\n")));
        return ExitCode.SUCCESS;
    }
}
