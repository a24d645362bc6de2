package org.phrenic.access.path;

import java.util.List;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.MovingStructure;
import org.phrenic.access.SkinPoint;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/**
 * Where a needle may enter the skin of a body that lies on its back, at rest. Cut ends are faces within
 * {@value #END_MM} mm of the upper or lower end of the skin that look up or down; arms begin lateral to the rib cage
 * above the sternal angle; the table is where the skin faces backward.
 */
public final class SkinEntries {
    private static final double END_MM = 12;
    /** Least vertical component of a normal of a cut end. */
    private static final double END_NORMAL = 0.6;
    /** Least backward component of a normal of the skin that lies on the table. */
    private static final double TABLE_NORMAL = 0.6;
    /** Part of the height of the sternum that lies below the sternal angle. */
    private static final double ANGLE_SHARE = 0.75;

    /** What a place of the skin is. */
    public enum Place {
        /** Skin that a needle may enter. */
        ENTRY("skin"),
        CUT_END("the cut end of the body"),
        ARM("where the arm is"),
        TABLE("where the table is");

        private final String label;

        Place(String label) {
            this.label = label;
        }

        public String label() {
            return label;
        }
    }

    private final Place[] places;

    /** @param anatomy a body with a skin */
    public SkinEntries(MovingAnatomy anatomy) {
        TriangleMesh skin = anatomy.skin().surface().rest();
        double[] box = skin.bounds();
        double[] normals = MeshMeasure.vertexNormals(skin);
        double[] cage = bounds(anatomy.structures(), StructureKind.RIB);
        double[] sternum = bounds(anatomy.structures(), StructureKind.STERNUM);
        double angle = sternum[2] + ANGLE_SHARE * (sternum[5] - sternum[2]);
        places = new Place[skin.vertexCount()];
        for (int v = 0; v < places.length; v++) {
            double z = skin.z(v);
            boolean atEnd = (z < box[2] + END_MM && normals[3 * v + 2] < -END_NORMAL)
                    || (z > box[5] - END_MM && normals[3 * v + 2] > END_NORMAL);
            boolean beside = skin.x(v) < cage[0] || skin.x(v) > cage[3];
            places[v] = atEnd
                    ? Place.CUT_END
                    : beside && z > angle ? Place.ARM : normals[3 * v + 1] > TABLE_NORMAL ? Place.TABLE : Place.ENTRY;
        }
    }

    /** Box of all structures of a kind at rest; infinite, low above high, if there are none. */
    private static double[] bounds(List<MovingStructure> structures, StructureKind kind) {
        double inf = Double.POSITIVE_INFINITY;
        List<Surface> all = structures.stream()
                .map(MovingStructure::surface)
                .filter(s -> s.kind() == kind)
                .toList();
        return all.isEmpty() ? new double[] {-inf, -inf, inf, inf, inf, inf} : Surface.bounds(all);
    }

    /** What a vertex of the skin is. */
    public Place place(int vertex) {
        return places[vertex];
    }

    /**
     * A point of the skin where a needle may enter.
     *
     * @param atRest position at end-expiration, LPS, mm
     * @throws BadInputException if the position is off the skin, or at a place that is no entry
     */
    public static SkinPoint pointAtRest(MovingAnatomy anatomy, double[] atRest) {
        SkinPoint point = SkinPoint.atRest(anatomy.skin(), atRest);
        Place place = new SkinEntries(anatomy).place(point.nearestVertex());
        if (place != Place.ENTRY) {
            throw new BadInputException(Numbers.format(
                    "entry: found (%.1f, %.1f, %.1f), %s, expected skin that a needle may enter",
                    atRest[0], atRest[1], atRest[2], place.label()));
        }
        return point;
    }
}
