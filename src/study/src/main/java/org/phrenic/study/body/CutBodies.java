package org.phrenic.study.body;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.io.volume.NiftiWriter;
import org.phrenic.patient.pipeline.ImportPipeline;
import org.phrenic.patient.pipeline.ImportRequest;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.patient.segmentation.LabelTable;

/** Bodies that are imported from simulated scans of another body, by the way that {@code phrenic import} takes. */
public final class CutBodies {
    private CutBodies() {}

    /**
     * One body for each cut. The scan is written to {@code FOLDER/NAME.nii.gz} and the body to {@code FOLDER/NAME}.
     *
     * @param template completes the bodies; loaded for each of them
     * @param folder receives scans and bodies
     */
    public static List<BodyCase> of(BodyCase source, Collection<BodyCut> cuts, Supplier<Thorax> template, Path folder) {
        String stem = source.name().replaceAll("^.*[/\\\\]", "");
        return cuts.stream()
                .map(cut -> {
                    String name = stem + "-" + cut.label();
                    return new BodyCase(
                            name,
                            stem + ", scanned: " + cut.description(),
                            source.height(),
                            () -> imported(name, source, cut, template, folder));
                })
                .toList();
    }

    private static Thorax imported(String name, BodyCase source, BodyCut cut, Supplier<Thorax> template, Path folder) {
        Path file = folder.resolve(name + ".nii.gz");
        NiftiWriter.write(file, CutScan.of(source.thorax().get(), cut));
        ImportResult result = ImportPipeline.run(
                ImportRequest.of(file, name, Optional.of(LabelTable.TOTALSEGMENTATOR), template.get()),
                (count, total, structure) -> {});
        result.write(folder.resolve(name));
        return result.body().thorax();
    }
}
