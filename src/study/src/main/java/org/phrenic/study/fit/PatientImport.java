package org.phrenic.study.fit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.BadInputException;
import org.phrenic.fit.FitPart;
import org.phrenic.fit.FitTarget;
import org.phrenic.fit.TargetAlignment;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.patient.ImportProgress;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.pipeline.ImportPipeline;
import org.phrenic.patient.pipeline.ImportRequest;
import org.phrenic.patient.pipeline.ImportResult;
import org.phrenic.patient.registration.ScanAlignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SimulationRun;

/**
 * A patient imported from two scans.
 *
 * @param body at end-expiration, completed from the virtual adult male
 * @param targets both lungs at the second breath level, in the axes of the body
 * @param alignment of the second scan
 * @param notes of both imports
 */
public record PatientImport(
        String name, Thorax body, List<FitTarget> targets, TargetAlignment alignment, List<String> notes) {
    private static final ImportProgress SILENT = (done, of, what) -> {};

    public PatientImport {
        targets = List.copyOf(targets);
        notes = List.copyOf(notes);
    }

    /**
     * Imports both scans, of which the first is taken to be at end-expiration. A volume whose labels have no names is
     * taken for a mask of both lungs.
     *
     * @param axes see {@link GeometryOverride#axes}; empty for the axes of the files
     * @throws BadInputException if a scan is missing, cannot be used or contains no lungs
     */
    public static PatientImport of(PatientScans pair, Optional<String> axes) {
        pair.requireBoth();
        Thorax template = SimulationRun.loadThorax(Scenario.defaults());
        PatientBody expired = run(pair, pair.expiration(), axes, Optional.of(template), Optional.empty())
                .body();
        if (!expired.canBreathe()) {
            throw new BadInputException(
                    pair.expiration() + ": found no whole lung, expected lungs to make a body from");
        }
        Thorax body = expired.thorax();
        ImportResult inspired = run(pair, pair.inspiration(), axes, Optional.empty(), Optional.of(body));
        List<FitTarget> targets = new ArrayList<>();
        for (FitPart part : List.of(FitPart.LUNG_RIGHT, FitPart.LUNG_LEFT)) {
            targets.add(FitTarget.of(
                    part,
                    inspired.body()
                            .structure(part.label())
                            .orElseThrow(() -> new BadInputException(
                                    pair.inspiration() + ": found no " + part.label() + ", expected both lungs"))
                            .structure()
                            .mesh()));
        }
        ScanAlignment alignment = inspired.alignment().orElseThrow();
        String sentence = alignment.sentence(body.name());
        List<String> notes = new ArrayList<>(expired.notes());
        inspired.body().notes().forEach(note -> notes.add("end of inhale: " + note));
        return new PatientImport(pair.name(), body, targets, new TargetAlignment(alignment.motion(), sentence), notes);
    }

    private static ImportResult run(
            PatientScans pair, Path file, Optional<String> axes, Optional<Thorax> template, Optional<Thorax> alignTo) {
        boolean named = !LabelVolumeFiles.read(file).names().isEmpty();
        return ImportPipeline.run(
                new ImportRequest(
                        file,
                        pair.name(),
                        named ? Optional.empty() : Optional.of(LabelTable.LUNGS),
                        Optional.empty(),
                        new GeometryOverride(axes, Optional.empty()),
                        template.map(t -> new ImportRequest.Completion(t, true)),
                        alignTo),
                SILENT);
    }
}
