package org.phrenic.cli;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.phrenic.cli.report.InfoText;
import org.phrenic.cli.report.MeshInfo;
import org.phrenic.cli.report.ScenarioInfo;
import org.phrenic.cli.report.ThoraxInfo;
import org.phrenic.cli.report.VolumeInfo;
import org.phrenic.document.JsonWriter;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code phrenic info}: what files hold. */
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
final class InfoCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "1..*",
            paramLabel = "FILE",
            description =
                    "A mesh (stl, obj, ply, vtk, vtp), a label volume (nii, nii.gz, nrrd, nhdr, mha, mhd), a scenario (yaml) or a folder of meshes.")
    private List<Path> files;

    @Option(names = "--json", description = "Print JSON: a list 'files'.")
    private boolean json;

    @Override
    public Integer call() {
        List<Map<String, Object>> all = new ArrayList<>();
        for (Path file : files) {
            all.add(describe(file));
        }
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.print(JsonWriter.format(Map.of("files", all)));
        } else {
            out.print(String.join("\n", all.stream().map(InfoText::of).toList()));
        }
        out.flush();
        return ExitCode.SUCCESS;
    }

    private static Map<String, Object> describe(Path file) {
        if (Files.isDirectory(file)) {
            return ThoraxInfo.of(file);
        }
        if (!Files.exists(file)) {
            throw new BadInputException(
                    file + ": no such file, expected a mesh, a volume, a scenario or a folder of meshes");
        }
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        if (name.endsWith(".yaml") || name.endsWith(".yml")) {
            return ScenarioInfo.of(file);
        }
        if (LabelVolumeFiles.isVolume(file)) {
            return VolumeInfo.of(file);
        }
        if (!MeshFiles.isMesh(file)) {
            throw new BadInputException(
                    file + ": found no mesh, volume, scenario or folder, expected a name that ends in yaml, "
                            + String.join(", ", MeshFiles.READABLE) + " or "
                            + String.join(", ", LabelVolumeFiles.READABLE));
        }
        return MeshInfo.of(file);
    }
}
