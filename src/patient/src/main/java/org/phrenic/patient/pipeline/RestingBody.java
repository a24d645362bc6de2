package org.phrenic.patient.pipeline;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Thorax;
import org.phrenic.document.OrderedValues;
import org.phrenic.file.Numbers;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.diaphragm.BreathLevel;
import org.phrenic.patient.diaphragm.EndExpiration;
import org.phrenic.patient.diaphragm.RaisedBody;
import org.phrenic.patient.registration.BodyCompletion;

/**
 * A completed body and the breath level of its scan. A body breathes from end-expiration.
 *
 * @param level breath level of the scan; empty if the scan shows too little of it
 * @param moved whether the body was brought from that level to end-expiration, or as near to it as domes may rise
 * @param raisedMm rise of the domes, mm
 */
public record RestingBody(PatientBody body, Optional<BreathLevel> level, boolean moved, double raisedMm) {
    /** A completed body at the breath level of its scan. */
    static RestingBody asScanned(PatientBody scanned, PatientBody completed) {
        MedianFrame frame = MedianFrame.of(completed.thorax());
        return new RestingBody(
                completed,
                BreathLevel.of(scanned.withEach(frame::toFrame), completed.withEach(frame::toFrame)),
                false,
                0);
    }

    /** Whether the scan is clearly one at inspiration. */
    public boolean isInspired() {
        return level.filter(BreathLevel::isInspired).isPresent();
    }

    /**
     * The body of the same scan at end-expiration, completed anew. Of a scan without bones, whose cage comes from the
     * lungs as they were, the whole body is moved.
     */
    RestingBody atEndExpiration(PatientBody scanned, Thorax template) {
        MedianFrame frame = MedianFrame.of(body.thorax());
        PatientBody straight = body.withEach(frame::toFrame);
        if (level.orElseThrow().mark() == BreathLevel.Mark.SHAPE) {
            RaisedBody raised = EndExpiration.of(straight, straight, level.orElseThrow());
            return new RestingBody(raised.body().withEach(frame::toScan), level, true, raised.domesMm());
        }
        RaisedBody raised = EndExpiration.of(scanned.withEach(frame::toFrame), straight, level.orElseThrow());
        PatientBody rest = raised.body().withEach(frame::toScan);
        return new RestingBody(BodyCompletion.complete(rest, template), level, true, raised.domesMm());
    }

    /**
     * The same with its diaphragm and skin. A body left at inspiration gets a note, and so does one whose domes stand
     * high or at unequal heights.
     */
    RestingBody with(PatientBody whole) {
        List<String> notes = new ArrayList<>();
        if (isInspired() && !moved) {
            notes.add("the scan is one at inspiration, "
                    + level.orElseThrow().stated()
                    + ", and is left as it is: it breathes less than from end-expiration");
        } else if (level.filter(BreathLevel::standsHigh).isPresent()) {
            notes.add("the scan is one with high domes, "
                    + level.orElseThrow().stated()
                    + ", and is left as it is: they stand so in pregnancy, obesity, ascites or a paresis, or "
                    + (BreathLevel.showsOrgansBelow(body.thorax()) ? "" : "fluid or collapse lifts the lungs, or ")
                    + "ribs or vertebrae are numbered one too low");
        }
        level.filter(BreathLevel::isUnequal)
                .ifPresent(found -> notes.add("the two sides of the scan differ, "
                        + found.stated()
                        + ": gas of the stomach or the bowel may have the label of a lung, or one side is paretic or"
                        + " lifted"));
        return new RestingBody(notes.isEmpty() ? whole : whole.withNotes(notes), level, moved, raisedMm);
    }

    /** A note on a scan that shows nothing by which its level can be measured; none where it can. */
    List<String> notesOfUnknownLevel(PatientBody scanned) {
        return level.isPresent() || BreathLevel.showsWholeLungs(scanned)
                ? List.of()
                : List.of("the scan does not tell how deep the breath is, and is taken for one at end-expiration");
    }

    /** What a view of the body states, such as "end-expiration (domes raised by 41 mm)". */
    public List<String> statements() {
        return moved ? List.of(Numbers.format("end-expiration (domes raised by %.0f mm)", raisedMm)) : List.of();
    }

    /** The entry of {@code import.json}. */
    Optional<OrderedValues> report() {
        return level.map(found -> new OrderedValues()
                .with(key(found, "right"), Double.isNaN(found.right()) ? null : found.right())
                .with(key(found, "left"), Double.isNaN(found.left()) ? null : found.left())
                .with("share_of_full_inspiration", found.share())
                .with("domes_below_end_expiration_mm", found.descentMm())
                .with("inspired", found.isInspired())
                .with("brought_to_end_expiration", moved));
    }

    private static String key(BreathLevel level, String side) {
        return (level.mark() == BreathLevel.Mark.LOWER_BORDERS ? "lung_border_" : "dome_") + side + "_vertebra";
    }
}
