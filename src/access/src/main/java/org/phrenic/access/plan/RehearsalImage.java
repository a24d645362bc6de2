package org.phrenic.access.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.ultrasound.BModeImage;
import org.phrenic.access.ultrasound.CurvilinearProbe;
import org.phrenic.access.ultrasound.ScannedSkin;
import org.phrenic.access.ultrasound.SonatedNeedle;
import org.phrenic.access.ultrasound.Ultrasound;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.ReportDocument.Picture;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.simulation.observe.Surface;

/**
 * An ultrasound image that a plan took, with the needle as it was.
 *
 * @param file name of its picture in the folder of the report; empty if there is none
 * @param timeS simulated time, s
 * @param probe how the probe was held
 * @param needle empty if it was not on or in the body
 * @param leftOut names of the structures that are too open to be seen
 */
public record RehearsalImage(
        String file,
        double timeS,
        ProbeHold probe,
        BModeImage image,
        Optional<SonatedNeedle> needle,
        List<String> leftOut) {
    /** Takes the images that the steps of a plan asked for, in their order. */
    public static List<RehearsalImage> of(Rehearsal rehearsal) {
        List<PlanStep.Image> steps = rehearsal.plan().steps().stream()
                .filter(PlanStep.Image.class::isInstance)
                .map(PlanStep.Image.class::cast)
                .toList();
        List<NeedleSnapshot> moments = rehearsal.snapshots().stream()
                .filter(NeedleSnapshot::isForUltrasound)
                .toList();
        List<RehearsalImage> images = new ArrayList<>();
        if (moments.isEmpty()) {
            return images;
        }
        List<Surface> surfaces = rehearsal.surfaces();
        Ultrasound ultrasound = new Ultrasound(
                surfaces,
                CurvilinearProbe.abdominal(),
                rehearsal.plan().scenario().threads(),
                Optional.of(rehearsal.target()));
        ScannedSkin skin = new ScannedSkin(surfaces);
        for (NeedleSnapshot moment : moments) {
            ProbeHold probe = steps.get(images.size()).probe();
            Optional<SonatedNeedle> needle = moment.placed()
                    ? Optional.of(new SonatedNeedle(
                            moment.hub(), moment.tip(), rehearsal.plan().needle()))
                    : Optional.empty();
            ImageMoment what = new ImageMoment(
                    probe.on(surfaces, skin).pose(moment.frame(), probe.angles()),
                    probe.settings(),
                    needle,
                    moment.target());
            BModeImage image = what.take(ultrasound, moment.frame());
            String file = Numbers.format("ultrasound_%04d.png", images.size() + 1);
            images.add(new RehearsalImage(file, moment.frame().timeS(), probe, image, needle, ultrasound.leftOut()));
        }
        return images;
    }

    /** The image without the file of its picture. */
    RehearsalImage withoutFile() {
        return new RehearsalImage("", timeS, probe, image, needle, leftOut);
    }

    /** The pictures of images that have a file. */
    static List<Picture> pictures(List<RehearsalImage> images) {
        return images.stream()
                .filter(image -> !image.file.isEmpty())
                .map(image -> new Picture(image.file, "Ultrasound image " + image.file, ""))
                .toList();
    }

    /** The caption of images, with what is left out of them. */
    static String caption(List<RehearsalImage> images) {
        String leftOut = images.stream()
                .flatMap(image -> image.leftOut.stream())
                .distinct()
                .collect(Collectors.joining(", "));
        return "Ultrasound, the probe's marker on the left."
                + (leftOut.isEmpty() ? "" : " Not in the images, as they are open: " + leftOut + ".");
    }

    /** Checks that the probes of all steps are on the skin. */
    static void requirePlaces(List<PlanStep> steps, MovingAnatomy anatomy) {
        List<Surface> surfaces =
                anatomy.structures().stream().map(MovingStructure::surface).toList();
        ScannedSkin skin = new ScannedSkin(surfaces);
        for (PlanStep step : steps) {
            Optional<ProbeHold> hold = step instanceof PlanStep.Image image
                    ? Optional.of(image.probe())
                    : step instanceof PlanStep.Probe probe ? probe.hold() : Optional.empty();
            try {
                hold.ifPresent(h -> h.on(surfaces, skin));
            } catch (BadInputException bad) {
                throw new BadInputException(step.place() + ": " + bad.getMessage(), bad);
            }
        }
    }

    /** The values in a fixed order. */
    Map<String, Object> toMap() {
        double depth = image.settings().depthMm();
        OrderedValues map = new OrderedValues();
        if (!file.isEmpty()) {
            map.put("file", file);
        }
        map.with("time_s", timeS)
                .with("probe", probe.toPlain())
                .with("face_mm", image.pose().face())
                .with("axial", image.pose().axial())
                .with("lateral", image.pose().lateral())
                .with("mm_per_pixel", image.mmPerPixel());
        if (!leftOut.isEmpty()) {
            map.put("left_out", leftOut);
        }
        needle.ifPresent(n -> map.with("needle_in_beam_mm", n.lengthInBeamMm(image.probe(), image.pose(), depth))
                .with("tip_in_beam", n.isTipInBeam(image.probe(), image.pose(), depth)));
        return map;
    }
}
