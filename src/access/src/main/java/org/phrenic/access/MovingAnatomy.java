package org.phrenic.access;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * The body as a frame shows it, ready to be asked what a path crosses. Taking a frame is for one thread; asking may
 * then be done by many.
 */
public final class MovingAnatomy {
    /** What {@code PathAnalyzer.nearestOfMargin} begins with where it is the lower border of a rib. */
    public static final String VESSELS_PREFIX = "vessels_";

    private final List<MovingStructure> structures = new ArrayList<>();
    private final List<MovingStructure> hazards = new ArrayList<>();
    private final List<CostalGroove> borders = new ArrayList<>();
    private final MovingStructure skin;
    private final MovingStructure liver;
    private final Optional<MovingStructure> diaphragm;
    private final Optional<PleuralReflection> pleura;
    private double timeS;

    /**
     * @param surfaces of a scene, in the order of its frames
     * @throws BadInputException with one sentence, if there is no skin or no liver, or liver or lungs stand still while
     *     the body breathes
     */
    public MovingAnatomy(List<Surface> surfaces) {
        for (int i = 0; i < surfaces.size(); i++) {
            MovingStructure structure = new MovingStructure(surfaces.get(i), i);
            structures.add(structure);
            if (structure.noGo().isPresent()) {
                hazards.add(structure);
            }
            if (surfaces.get(i).kind() == StructureKind.RIB) {
                borders.add(new CostalGroove(structure));
            }
        }
        skin = require(StructureKind.SKIN, "skin");
        liver = require(StructureKind.LIVER, "liver");
        requireMotion(StructureKind.LIVER, "a liver that stands still (liver: false)");
        requireMotion(StructureKind.LUNG, "lungs that stand still (lungs: off)");
        diaphragm = find(StructureKind.DIAPHRAGM);
        pleura = diaphragm.map(d -> new PleuralReflection(d.surface().rest()));
    }

    private MovingStructure require(StructureKind kind, String name) {
        return find(kind)
                .orElseThrow(() -> new BadInputException(
                        "the body: found no " + name + ", expected one to rehearse liver access on"));
    }

    private void requireMotion(StructureKind kind, String still) {
        for (MovingStructure structure : structures) {
            if (structure.surface().kind() == kind && structure.surface().motion() == Surface.Motion.STILL) {
                throw new BadInputException("the body: found " + still
                        + ", expected what moves with the breath to rehearse liver access on");
            }
        }
    }

    private Optional<MovingStructure> find(StructureKind kind) {
        return structures.stream().filter(s -> s.surface().kind() == kind).findFirst();
    }

    /** Takes over where everything is. */
    public void update(Frame frame) {
        structures.forEach(s -> s.update(frame));
        timeS = frame.timeS();
    }

    /** Simulated time of the frame, s. */
    public double timeS() {
        return timeS;
    }

    /** All structures, in the order of the frame. */
    public List<MovingStructure> structures() {
        return structures;
    }

    /** For people: what a margin was taken from, as {@code PathAnalyzer.nearestOfMargin} names it. */
    public String labelOf(String nearest) {
        boolean border = nearest.startsWith(VESSELS_PREFIX);
        String name = border ? nearest.substring(VESSELS_PREFIX.length()) : nearest;
        return structures.stream()
                .filter(s -> s.surface().name().equals(name))
                .map(s -> (border ? "the vessels below " : "") + s.label())
                .findFirst()
                .orElse("");
    }

    /** What a needle should not touch. */
    public List<MovingStructure> hazards() {
        return hazards;
    }

    public List<CostalGroove> borders() {
        return borders;
    }

    /** The skin. */
    public MovingStructure skin() {
        return skin;
    }

    /** The liver. */
    public MovingStructure liver() {
        return liver;
    }

    public Optional<MovingStructure> diaphragm() {
        return diaphragm;
    }

    public Optional<PleuralReflection> pleura() {
        return pleura;
    }
}
