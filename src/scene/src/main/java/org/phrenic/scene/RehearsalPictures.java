package org.phrenic.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalImage;
import org.phrenic.access.plan.RehearsalReport;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.file.OutputException;

/**
 * Writes the picture files of the report of a rehearsal. A picture that cannot be drawn or written is missing in the
 * report, which says so in one sentence.
 */
public final class RehearsalPictures {
    /** Draws pictures where there is a graphics context. */
    @FunctionalInterface
    public interface Drawing {
        void draw(Consumer<NeedlePictures> what);
    }

    private final Rehearsal rehearsal;
    private final Path folder;
    private final List<Picture> needle = new ArrayList<>();
    private final List<Picture> map = new ArrayList<>();
    private String missing = "";

    public RehearsalPictures(Rehearsal rehearsal, Path folder) {
        this.rehearsal = rehearsal;
        this.folder = folder;
    }

    /** Draws the needle and the access map; ends at the first picture that cannot be drawn, and keeps those before. */
    public void draw(Drawing drawing) {
        String title = rehearsal.plan().title();
        try {
            for (NeedleSnapshot moment : rehearsal.needleViews()) {
                boolean isSample = moment.name().startsWith("sample");
                Consumer<String> written = file -> {
                    if (isSample) {
                        needle.add(new Picture(file, "Needle and target in the body, " + file, ""));
                    }
                };
                drawing.draw(pictures -> pictures.writeNeedleViews(folder, moment, title, written, this::setMissing));
            }
            Consumer<String> written = file -> map.add(new Picture(file, "Access map on the skin, " + file, ""));
            drawing.draw(
                    pictures -> pictures.writeAccessMap(folder, rehearsal.map(), title, written, this::setMissing));
        } catch (RuntimeException undrawn) {
            setMissing(undrawn);
        }
    }

    /** Writes the ultrasound images; the report names no file that is not written. */
    public void writeImages(RehearsalReport report) {
        for (RehearsalImage image : report.images()) {
            try {
                UltrasoundPicture.write(folder.resolve(image.file()), image.image());
            } catch (OutputException unwritten) {
                setMissing(unwritten);
                report.leaveOutFile(image);
            }
        }
    }

    /** Some pictures are missing for a reason; the first reason is kept. */
    public void setMissing(Exception reason) {
        setMissing(reason.getMessage() == null ? reason.toString() : reason.getMessage());
    }

    public void setMissing(String reason) {
        missing = missing.isEmpty() ? reason : missing;
    }

    /** Why not all pictures were written; empty if they were. */
    public String missing() {
        return missing;
    }

    /** Pictures of the needle at the samples. */
    public List<Picture> needle() {
        return List.copyOf(needle);
    }

    /** Pictures of the access map. */
    public List<Picture> map() {
        return List.copyOf(map);
    }
}
