package org.phrenic.patient.pipeline;

import java.nio.file.Files;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.AbsentStructures;
import org.phrenic.patient.ImportProgress;
import org.phrenic.patient.MeshingSettings;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.ScanFragments;
import org.phrenic.patient.ScanImport;
import org.phrenic.patient.SkinEnvelope;
import org.phrenic.patient.diaphragm.BreathLevel;
import org.phrenic.patient.diaphragm.DiaphragmCompletion;
import org.phrenic.patient.diaphragm.SheetQuality;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.label.InterpolatedLabels;
import org.phrenic.patient.label.LabelGuess;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.label.LungMoments;
import org.phrenic.patient.label.NamesBeside;
import org.phrenic.patient.label.StatedAxes;
import org.phrenic.patient.registration.BodyCompletion;
import org.phrenic.patient.registration.ScanAlignment;

/** Turns a scan or a folder of meshes into a body: reads it, meshes its labels, and completes or aligns the body. */
public final class ImportPipeline {
    private ImportPipeline() {}

    /** @throws BadInputException if the file cannot be imported; the message is one sentence */
    public static ImportResult run(ImportRequest request, ImportProgress progress) {
        String file = request.file().toString();
        progress.stage("reading " + file);
        if (Files.isDirectory(request.file()) && !LabelVolumeFiles.isVolume(request.file())) {
            LabelVolumeFiles.refuse(request.file(), "the folder of one scan");
            boolean ofVolumes = request.labels().isPresent()
                    || request.edgeMm().isPresent()
                    || !request.geometry().equals(GeometryOverride.NONE);
            if (ofVolumes) {
                throw new BadInputException(file + ": found a folder of meshes and --labels, --axes, --spacing or"
                        + " --edge, which are of label volumes, expected none of them");
            }
            MeshFolder folder = MeshFolder.read(request.file(), request.name());
            return result(request, Optional.empty(), folder.body(), progress).withStatements(folder.statements());
        }

        LabelVolume stored = request.geometry().apply(LabelVolumeFiles.read(request.file()), file);
        LabelVolume volume = NamesBeside.added(request.file(), stored.withEmptyLayers(), request.labels());
        LabelTable table = table(request, volume, progress);
        checkAxes(request, volume, table);
        PatientBody scanned = new ScanImport(volume, file, MeshingSettings.PAPER, request.edgeMm(), progress)
                .run(table, request.name());
        return result(request, Optional.of(stored.grid()), scanned, progress);
    }

    /** Aligns or completes a body as the request says. */
    private static ImportResult result(
            ImportRequest request, Optional<LabelGrid> grid, PatientBody scanned, ImportProgress progress) {
        String file = request.file().toString();
        if (request.alignTo().isPresent()) {
            ScanAlignment.Aligned aligned = aligned(request, scanned);
            return ImportResult.of(file, grid, aligned.body(), Optional.of(aligned.alignment()));
        }
        if (request.completion().isEmpty()) {
            return ImportResult.of(file, grid, scanned, Optional.empty());
        }
        ImportResult result = ImportResult.of(file, grid, completed(request, grid, scanned, progress));
        result.quality().flatMap(SheetQuality::refusal).ifPresent(why -> {
            throw new BadInputException(file + ": " + why);
        });
        return result;
    }

    /** Refuses a volume whose structures contradict the axes of the file, unless the request states axes. */
    private static void checkAxes(ImportRequest request, LabelVolume volume, LabelTable table) {
        if (request.geometry().axes().isPresent()) {
            return;
        }
        Optional<Thorax> known =
                request.alignTo().or(() -> request.completion().map(ImportRequest.Completion::template));
        StatedAxes.contradicted(volume, table, known.flatMap(LungMoments::of)).ifPresent(axes -> {
            throw new BadInputException(request.file() + ": " + axes.sentence() + "; " + axes.expected());
        });
    }

    private static LabelTable table(ImportRequest request, LabelVolume volume, ImportProgress progress) {
        if (request.labels().isEmpty()) {
            LabelGuess guess = LabelGuess.of(volume);
            if (guess.table().isEmpty()) {
                volume.notes().forEach(progress::stage);
            }
            progress.stage(guess.reason());
            return guess.require(request.file().toString());
        }
        if (!volume.isImage()) {
            InterpolatedLabels.problem(volume.grid()).ifPresent(problem -> {
                throw new BadInputException(request.file() + ": " + problem);
            });
        }
        return LabelTable.of(request.labels().get(), volume);
    }

    private static RestingBody completed(
            ImportRequest request, Optional<LabelGrid> grid, PatientBody all, ImportProgress progress) {
        ImportRequest.Completion completion = request.completion().orElseThrow();
        Thorax template = completion.template();
        PatientBody scanned = ScanFragments.leftOut(all, template);
        progress.stage("bringing " + template.name() + " to the scan for what it lacks");
        RestingBody resting;
        List<String> absent;
        try {
            resting = RestingBody.asScanned(scanned, BodyCompletion.complete(scanned, template));
            PatientBody asScanned = resting.body();
            absent = grid.map(view -> AbsentStructures.notes(asScanned, view)).orElse(List.of());
            if (resting.isInspired() && !completion.keepLevel()) {
                progress.stage("bringing the scan from inspiration to end-expiration");
                resting = resting.atEndExpiration(scanned, template);
            }
        } catch (BadInputException problem) {
            throw new BadInputException(request.file() + ": " + problem.getMessage(), problem);
        }
        progress.stage("building the diaphragm from the organs and bones that it touches");
        PatientBody whole = DiaphragmCompletion.complete(
                resting.body().withNotes(absent),
                resting.moved(),
                resting.level().flatMap(BreathLevel::parted));
        List<String> unknown = completion.keepLevel() ? List.of() : resting.notesOfUnknownLevel(scanned);
        return resting.with(SkinEnvelope.complete(whole.withNotes(unknown)));
    }

    private static ScanAlignment.Aligned aligned(ImportRequest request, PatientBody scanned) {
        Thorax first = request.alignTo().orElseThrow();
        try {
            return ScanAlignment.aligned(first, scanned);
        } catch (IllegalArgumentException e) {
            throw new BadInputException(request.file() + " and " + first.name() + ": " + e.getMessage(), e);
        }
    }
}
