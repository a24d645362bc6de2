package org.phrenic.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DiaphragmSide;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.CappedSurface;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.mesh.voxel.MeshVoxelizer;
import org.phrenic.mesh.voxel.VoxelBox;
import org.phrenic.simulation.observe.Surface;

/**
 * The regions that a body is divided into: {@link #OUTSIDE}, {@link #WALL}, {@link #ABDOMEN}, and from {@link #FIRST}
 * on the inside of each closed surface, in the order of the surfaces. The abdomen is what lies below the abdominal face
 * of the diaphragm along the long axis of the body; the wall is everything else that is in no closed surface: chest
 * wall, mediastinum, abdominal wall, back.
 */
final class BodyRegions {
    static final int OUTSIDE = 0;
    static final int WALL = 1;
    static final int ABDOMEN = 2;
    static final int FIRST = 3;
    /** How far the abdomen reaches below the diaphragm, mm: beyond the end of any body. */
    private static final double SHADOW_MM = 2000;

    private static final int MOST = 252;
    /** The diaphragm nearer to a lung than this is covered by it, mm. */
    private static final double BELOW_LUNG_MM = 6;
    /** The diaphragm nearer to the cage than this may peel off it, mm. */
    private static final double APPOSED_MM = 15;

    /** Kinds of closed surfaces; where two overlap, the later one holds. */
    private static final List<StructureKind> ORDER = List.of(
            StructureKind.MUSCLE,
            StructureKind.OTHER,
            StructureKind.ORGAN,
            StructureKind.LIVER,
            StructureKind.VESSEL,
            StructureKind.LESION,
            StructureKind.DIAPHRAGM,
            StructureKind.LUNG,
            StructureKind.DISC,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.BONE,
            StructureKind.RIB);

    private final List<Surface> surfaces;
    private final int diaphragm;
    /** Corners of the triangles of the diaphragm's abdominal face. */
    private final int[] abdominalFace;
    /** Corners of the triangles of its thoracic face. */
    private final int[] thoracicFace;
    /** Closed surfaces, in the order in which they are filled. */
    private final int[] order;
    /** Places of the skins among the surfaces. */
    private final int[] skins;
    /** Skins and closed surfaces, by their places, with their holes closed, so that all of them have an inside. */
    private final Map<Integer, CappedSurface> capped = new TreeMap<>();

    BodyRegions(List<Surface> surfaces, Diaphragm sheet) {
        this.surfaces = surfaces;
        if (surfaces.size() > MOST) {
            throw new BadInputException(
                    "motion: found a body of " + surfaces.size() + " structures, expected " + MOST + " at most");
        }
        diaphragm = IntStream.range(0, surfaces.size())
                .filter(i -> surfaces.get(i).kind() == StructureKind.DIAPHRAGM)
                .findFirst()
                .orElseThrow();
        int[] t = sheet.sheet().triangles();
        abdominalFace = IntStream.range(0, t.length)
                .filter(i -> !sheet.isThoracicTriangle(i / 3))
                .map(i -> t[i])
                .toArray();
        thoracicFace = IntStream.range(0, t.length)
                .filter(i -> sheet.isThoracicTriangle(i / 3))
                .map(i -> t[i])
                .toArray();
        order = IntStream.range(0, surfaces.size())
                .filter(this::isRegion)
                .boxed()
                .sorted(Comparator.comparing(i -> ORDER.indexOf(surfaces.get(i).kind())))
                .mapToInt(Integer::intValue)
                .toArray();
        skins = IntStream.range(0, surfaces.size())
                .filter(i -> surfaces.get(i).kind() == StructureKind.SKIN)
                .toArray();
        IntStream.concat(IntStream.of(skins), IntStream.of(order))
                .forEach(i -> capped.put(i, new CappedSurface(surfaces.get(i).rest())));
    }

    /** Whether a surface has an inside of its own: it is closed, but for holes, and neither skin nor pleura. */
    boolean isRegion(int surface) {
        Surface s = surfaces.get(surface);
        return ORDER.contains(s.kind()) && MeshMeasure.hasInside(s.rest());
    }

    /** Closed surfaces, those that hold in an overlap last. */
    int[] order() {
        return order.clone();
    }

    /** Whether the surface moves the soft tissue of the wall ({@link #WALL}) or of the abdomen. */
    boolean moves(int surface, int soft) {
        Surface s = surfaces.get(surface);
        DiaphragmSide side = DiaphragmSide.of(s.kind(), s.name());
        return switch (s.kind()) {
            case LUNG, DIAPHRAGM -> false;
            case LIVER, LESION -> soft == ABDOMEN;
            case RIB, COSTAL_CARTILAGE, STERNUM, SKIN, PLEURA, BONE -> soft == WALL;
            default -> side == DiaphragmSide.NEITHER || (side == DiaphragmSide.BELOW) == (soft == ABDOMEN);
        };
    }

    /** Whether a region belongs to the wall or abdomen, for the soft tissue around it. */
    boolean belongs(int region, int soft) {
        if (region >= FIRST) {
            return region - FIRST != diaphragm && moves(region - FIRST, soft);
        }
        return region == soft;
    }

    /** The faces along which the soft tissue of the wall or the abdomen slides. */
    List<SlidingFace> slidingFaces(int soft) {
        if (soft == ABDOMEN) {
            return List.of(new SlidingFace(diaphragm, surfaces.get(diaphragm).rest(), abdominalFace));
        }
        List<SlidingFace> faces = new ArrayList<>();
        for (int i = 0; i < surfaces.size(); i++) {
            TriangleMesh rest = surfaces.get(i).rest();
            if (surfaces.get(i).kind() == StructureKind.LUNG) {
                faces.add(new SlidingFace(i, rest, rest.triangles()));
            }
        }
        faces.add(new SlidingFace(diaphragm, surfaces.get(diaphragm).rest(), mediastinalFace()));
        return faces;
    }

    /** The part of the thoracic face that is neither below a lung nor apposed to the chest wall. */
    private int[] mediastinalFace() {
        TriangleMesh sheet = surfaces.get(diaphragm).rest();
        boolean[] free = new boolean[sheet.vertexCount()];
        Arrays.fill(free, true);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (Surface s : surfaces) {
            double reach =
                    switch (s.kind()) {
                        case LUNG -> BELOW_LUNG_MM;
                        case RIB, COSTAL_CARTILAGE, STERNUM -> APPOSED_MM;
                        default -> 0;
                    };
            TriangleTree tree = reach > 0 ? new TriangleTree(s.rest()) : null;
            for (int v = 0; tree != null && v < free.length; v++) {
                free[v] &= !tree.closest(sheet.x(v), sheet.y(v), sheet.z(v), reach, hit);
            }
        }
        return IntStream.range(0, thoracicFace.length)
                .filter(i -> free[thoracicFace[i / 3 * 3]]
                        && free[thoracicFace[i / 3 * 3 + 1]]
                        && free[thoracicFace[i / 3 * 3 + 2]])
                .map(i -> thoracicFace[i])
                .toArray();
    }

    /**
     * The region of each voxel of a box.
     *
     * @param positions vertices of each surface, in the state that is asked for
     */
    byte[] label(VoxelBox box, List<double[]> positions) {
        int[] size = box.size();
        double[] toVoxel = box.toVoxel();
        byte[] labels = new byte[size[0] * size[1] * size[2]];
        MeshVoxelizer voxelizer = new MeshVoxelizer(size[0], size[1], size[2], toVoxel, labels);
        for (int i : skins) {
            voxelizer.fill(capped.get(i).at(positions.get(i)), WALL);
        }
        fillAbdomen(box, positions.get(diaphragm), labels);
        for (int i : order) {
            voxelizer.fill(capped.get(i).at(positions.get(i)), FIRST + i);
        }
        return labels;
    }

    /**
     * Turns the wall below the diaphragm into abdomen. The abdominal face and a copy of it far below enclose that space
     * along lines in the direction of the grid that is nearest to the long axis.
     */
    private void fillAbdomen(VoxelBox box, double[] sheet, byte[] labels) {
        int[] size = box.size();
        double[] toVoxel = box.toVoxel();
        int up = 0;
        for (int axis = 1; axis < 3; axis++) {
            up = Math.abs(toVoxel[4 * axis + 2]) / norm(toVoxel, axis)
                            > Math.abs(toVoxel[4 * up + 2]) / norm(toVoxel, up)
                    ? axis
                    : up;
        }
        int[] axes = {up, (up + 1) % 3, (up + 2) % 3};
        double[] permuted = new double[12];
        for (int row = 0; row < 3; row++) {
            System.arraycopy(toVoxel, 4 * axes[row], permuted, 4 * row, 4);
        }
        byte[] below = new byte[labels.length];
        new MeshVoxelizer(size[axes[0]], size[axes[1]], size[axes[2]], permuted, below)
                .fill(shadow(sheet, box.toMm(), up), 1);
        int[] stride = {1, size[0], size[0] * size[1]};
        int at = 0;
        for (int c = 0; c < size[axes[2]]; c++) {
            for (int b = 0; b < size[axes[1]]; b++) {
                for (int a = 0; a < size[axes[0]]; a++) {
                    int voxel = a * stride[axes[0]] + b * stride[axes[1]] + c * stride[axes[2]];
                    if (below[at++] == 1 && labels[voxel] == WALL) {
                        labels[voxel] = ABDOMEN;
                    }
                }
            }
        }
    }

    private static double norm(double[] m, int row) {
        return Math.sqrt(m[4 * row] * m[4 * row] + m[4 * row + 1] * m[4 * row + 1] + m[4 * row + 2] * m[4 * row + 2]);
    }

    private TriangleMesh shadow(double[] sheet, double[] toMm, int up) {
        double[] step = {toMm[up], toMm[4 + up], toMm[8 + up]};
        double length = Math.sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
        double down = -SHADOW_MM / length * Math.signum(step[2]);
        double[] p = new double[2 * sheet.length];
        for (int k = 0; k < sheet.length; k++) {
            p[k] = sheet[k];
            p[sheet.length + k] = sheet[k] + down * step[k % 3];
        }
        int[] t = new int[2 * abdominalFace.length];
        for (int i = 0; i < abdominalFace.length; i++) {
            t[i] = abdominalFace[i];
            t[abdominalFace.length + i] = abdominalFace[i] + sheet.length / 3;
        }
        return new TriangleMesh(p, t);
    }
}
