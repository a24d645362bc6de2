package org.phrenic.access;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * The structures of a scene in their current positions, ready for path queries. {@link #update} must be called from one
 * thread. Between updates, queries may run on many threads.
 */
public final class MovingAnatomy {
    /** Prefix for the name of a rib when a margin is measured from its costal groove. */
    public static final String VESSELS_PREFIX = "vessels_";

    /** What the display name of such a margin begins with. */
    private static final String VESSELS_LABEL = "the vessels below ";

    private final List<MovingStructure> structures;
    private final List<MovingStructure> hazards;
    private final List<CostalGroove> grooves;
    private final MovingStructure skin;
    private final MovingStructure liver;
    private final Optional<MovingStructure> diaphragm;
    private final Optional<PleuralReflection> reflection;
    private final List<MovingStructure> pleurae;
    private final Set<Side> sidesWithoutPleura = EnumSet.of(Side.RIGHT, Side.LEFT);
    private final double midlineX;
    private double timeS;

    /**
     * @param surfaces surfaces of a scene, in the order of its frames
     * @throws BadInputException if skin or liver is missing, several skins are about the liver or none is, or the liver
     *     or the lungs do not move
     */
    public MovingAnatomy(List<Surface> surfaces) {
        List<MovingStructure> all = new ArrayList<>();
        surfaces.forEach(surface -> all.add(new MovingStructure(surface, all.size())));
        structures = List.copyOf(all);
        hazards = structures.stream().filter(s -> s.noGo().isPresent()).toList();
        grooves = structures.stream()
                .filter(s -> s.surface().kind() == StructureKind.RIB)
                .map(CostalGroove::new)
                .toList();
        skin = require(TrunkSkin.of(surfaces).map(s -> structures.get(surfaces.indexOf(s))), "skin");
        liver = require(find(StructureKind.LIVER), "liver");
        requireMotion(
                StructureKind.LIVER,
                "a liver that stands still (liver: false, or too far below the diaphragm), expected one that moves with"
                        + " the breath (liver: true, in the window Tune breathing > Forces > Liver)");
        requireMotion(
                StructureKind.LUNG,
                "lungs that stand still (lungs: off), expected some that move with the breath (lungs: embedded, in the"
                        + " window Tune breathing > Forces > Lungs)");
        diaphragm = find(StructureKind.DIAPHRAGM);
        pleurae = structures.stream()
                .filter(s -> s.surface().kind() == StructureKind.PLEURA)
                .toList();
        pleurae.forEach(p -> sidesWithoutPleura.removeIf(
                side -> p.surface().side() == side || p.surface().side() == Side.MIDLINE));
        reflection = diaphragm
                .filter(d -> !sidesWithoutPleura.isEmpty())
                .map(d -> new PleuralReflection(d.surface().rest()));
        midlineX = Midline.x(surfaces, s -> s, s -> s.rest().bounds());
    }

    private static MovingStructure require(Optional<MovingStructure> found, String name) {
        return found.orElseThrow(() ->
                new BadInputException("the body: found no " + name + ", expected one to rehearse liver access on"));
    }

    private void requireMotion(StructureKind kind, String problem) {
        if (structures.stream()
                .map(MovingStructure::surface)
                .anyMatch(s -> s.kind() == kind && s.motion() == Surface.Motion.STILL)) {
            throw new BadInputException("the body: found " + problem);
        }
    }

    private Optional<MovingStructure> find(StructureKind kind) {
        return structures.stream().filter(s -> s.surface().kind() == kind).findFirst();
    }

    /** Moves all structures to their positions in a frame. */
    public void update(Frame frame) {
        structures.forEach(s -> s.update(frame));
        timeS = frame.timeS();
    }

    /** Simulated time of the frame, s. */
    public double timeS() {
        return timeS;
    }

    /** All structures, in the order of the surfaces in a frame. */
    public List<MovingStructure> structures() {
        return structures;
    }

    /** Display name of the structure that a margin is measured from, given its name in {@code PathAnalyzer.Margin}. */
    public String labelOf(String nearest) {
        boolean groove = nearest.startsWith(VESSELS_PREFIX);
        String name = groove ? nearest.substring(VESSELS_PREFIX.length()) : nearest;
        return structures.stream()
                .filter(s -> s.surface().name().equals(name))
                .map(s -> (groove ? VESSELS_LABEL : "") + s.label())
                .findFirst()
                .orElse("");
    }

    /** Structures that belong to a no-go zone. */
    public List<MovingStructure> hazards() {
        return hazards;
    }

    public List<CostalGroove> grooves() {
        return grooves;
    }

    /** The skin about the liver. */
    public MovingStructure skin() {
        return skin;
    }

    public MovingStructure liver() {
        return liver;
    }

    /** The diaphragm, or empty if the body has none. */
    public Optional<MovingStructure> diaphragm() {
        return diaphragm;
    }

    /** The surfaces of the parietal pleura; on a side without one its reflection is a rule. */
    public List<MovingStructure> pleurae() {
        return pleurae;
    }

    /** Whether a side of the body has a diaphragm and no surface of the pleura. */
    public boolean hasRuledPleura() {
        return reflection.isPresent();
    }

    /**
     * Whether a place of the diaphragm, given at rest, borders the pleural recess by the rule of the reflection. On a
     * side with a surface of the pleura that surface tells, and no place does.
     */
    public boolean bordersRuledRecess(double[] rest) {
        return sidesWithoutPleura.contains(rest[0] < midlineX ? Side.RIGHT : Side.LEFT)
                && reflection.filter(r -> r.isAbove(rest[0], rest[1], rest[2])).isPresent();
    }
}
