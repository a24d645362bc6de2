package org.phrenic.scene;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;

/** One surface on the graphics card: positions, normals and traits of its vertices, triangles, and edges once they are asked for. */
final class SurfaceBuffers {
    private static final int POSITION = 0;
    private static final int NORMAL = 1;
    private static final int TRAIT = 2;
    private static final int QUANTITY = 3;

    /** A surface that encloses a body may have this share of edges with one triangle only. */
    private static final double MOST_OPEN = 0.02;

    private final GlObjects objects;
    private final Surface surface;
    private final int index;
    private final VertexNormals normals;
    private final FloatBuffer positions;
    private final IntBuffer packed;
    private final float[] pose = identity();
    private final int vertexArray;
    private final int positionBuffer;
    private final int normalBuffer;
    private final int traitBuffer;
    private final int triangleBuffer;
    private final int triangleCount;
    private final boolean closed;
    private int restArray;
    private int restBuffer;
    private int edgeBuffer;
    private int edgeCount;
    private int quantityBuffer;
    private FieldValues values;

    /**
     * @param index of the surface in a frame
     * @param openness where the light that reaches it is looked up
     */
    SurfaceBuffers(GL3 gl, GlObjects objects, Surface surface, int index, Openness openness) {
        this.objects = objects;
        this.surface = surface;
        this.index = index;
        TriangleMesh mesh = surface.rest();
        int n = mesh.vertexCount();
        int[] triangles = outwards(mesh);
        normals = new VertexNormals(triangles, n);
        positions = Buffers.newDirectFloatBuffer(3 * n);
        packed = Buffers.newDirectIntBuffer(n);
        for (int i = 0; i < 3 * n; i++) {
            positions.put(i, (float) mesh.positions()[i]);
        }
        normals.of(positions, packed);
        boolean moving = surface.motion() == Surface.Motion.DEFORMING;
        int usage = moving ? GL3.GL_STREAM_DRAW : GL3.GL_STATIC_DRAW;
        vertexArray = objects.vertexArray(gl);
        positionBuffer = objects.buffer(gl);
        normalBuffer = objects.buffer(gl);
        traitBuffer = objects.buffer(gl);
        triangleBuffer = objects.buffer(gl);
        triangleCount = triangles.length / 3;
        int[] uses = MeshEdges.uses(triangles);
        closed = Arrays.stream(uses).filter(count -> count == 1).count() <= MOST_OPEN * uses.length;
        gl.glBindVertexArray(vertexArray);
        objects.fill(gl, GL3.GL_ARRAY_BUFFER, positionBuffer, positions, usage);
        attribute(gl, POSITION, 3, GL3.GL_FLOAT, false);
        objects.fill(gl, GL3.GL_ARRAY_BUFFER, normalBuffer, packed, usage);
        attribute(gl, NORMAL, 4, GL3.GL_INT_2_10_10_10_REV, true);
        IntBuffer traits = new VertexTraits(surface).packed(openness.of(mesh, normals));
        objects.fill(gl, GL3.GL_ARRAY_BUFFER, traitBuffer, traits, GL3.GL_STATIC_DRAW);
        attribute(gl, TRAIT, 4, GL3.GL_UNSIGNED_BYTE, true);
        IntBuffer corners = Buffers.newDirectIntBuffer(triangles);
        objects.fill(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, triangleBuffer, corners, GL3.GL_STATIC_DRAW);
    }

    private static void attribute(GL3 gl, int location, int size, int type, boolean normalized) {
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribPointer(location, size, type, normalized, 0, 0);
    }

    private static float[] identity() {
        return new float[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    }

    /** The triangles, turned round if they look inwards, which files of others may do. */
    private static int[] outwards(TriangleMesh mesh) {
        int[] triangles = mesh.triangles().clone();
        double[] box = mesh.bounds();
        double sum = 0;
        double[] p = mesh.positions();
        for (int t = 0; t < triangles.length; t += 3) {
            double[] u = new double[9];
            for (int k = 0; k < 9; k++) {
                u[k] = p[3 * triangles[t + k / 3] + k % 3] - (box[k % 3] + box[3 + k % 3]) / 2;
            }
            sum += u[0] * (u[4] * u[8] - u[5] * u[7])
                    + u[1] * (u[5] * u[6] - u[3] * u[8])
                    + u[2] * (u[3] * u[7] - u[4] * u[6]);
        }
        if (sum < 0) {
            for (int t = 0; t < triangles.length; t += 3) {
                int swap = triangles[t];
                triangles[t] = triangles[t + 1];
                triangles[t + 1] = swap;
            }
        }
        return triangles;
    }

    /** Takes over where the surface is in a frame. */
    void upload(GL3 gl, Frame frame) {
        switch (surface.motion()) {
            case DEFORMING -> {
                positions.put(0, frame.positions(index));
                normals.of(positions, packed);
                objects.refill(gl, positionBuffer, positions);
                objects.refill(gl, normalBuffer, packed);
            }
            case RIGID -> {
                place(frame.pose(index));
            }
            case STILL -> {
                // It is where it was.
            }
        }
    }

    /** Puts it somewhere by three rows of four. */
    void place(float[] rows) {
        for (int i = 0; i < Frame.POSE_LENGTH; i++) {
            pose[4 * (i % 4) + i / 4] = rows[i];
        }
    }

    /** Sends the values of a quantity. */
    void uploadField(GL3 gl, ColourField field, float[] given) {
        if (values == null) {
            values = new FieldValues(surface);
            quantityBuffer = objects.buffer(gl);
            gl.glBindVertexArray(vertexArray);
            gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, quantityBuffer);
            attribute(gl, QUANTITY, 1, GL3.GL_FLOAT, false);
        }
        float[] shown =
                switch (field) {
                    case NONE -> values.zero();
                    case DISTANCE, ACCESS -> given == null ? values.zero() : given;
                    case STRAIN ->
                        surface.motion() == Surface.Motion.DEFORMING ? values.strain(positions) : values.zero();
                    case DISPLACEMENT ->
                        switch (surface.motion()) {
                            case DEFORMING -> values.displacement(positions);
                            case RIGID -> values.displacement(rows());
                            case STILL -> values.zero();
                        };
                };
        objects.refill(gl, quantityBuffer, FloatBuffer.wrap(shown));
    }

    private float[] rows() {
        float[] rows = new float[Frame.POSE_LENGTH];
        for (int i = 0; i < rows.length; i++) {
            rows[i] = pose[4 * (i % 4) + i / 4];
        }
        return rows;
    }

    /** Where it is, a column-major 4 x 4 matrix. */
    float[] pose() {
        return pose;
    }

    Surface surface() {
        return surface;
    }

    /** Whether it encloses a body, but for small holes. */
    boolean isClosed() {
        return closed;
    }

    void draw(GL3 gl) {
        gl.glBindVertexArray(vertexArray);
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, triangleBuffer);
        gl.glDrawElements(GL3.GL_TRIANGLES, 3 * triangleCount, GL3.GL_UNSIGNED_INT, 0);
        objects.drew(triangleCount);
    }

    /** Draws its edges, where it is now or where it rests. */
    void drawEdges(GL3 gl, boolean atRest) {
        if (edgeBuffer == 0) {
            edgeBuffer = objects.buffer(gl);
            int[] edges = MeshEdges.of(surface.rest().triangles());
            edgeCount = edges.length / 2;
            gl.glBindVertexArray(vertexArray);
            IntBuffer pairs = Buffers.newDirectIntBuffer(edges);
            objects.fill(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, edgeBuffer, pairs, GL3.GL_STATIC_DRAW);
        }
        gl.glBindVertexArray(atRest ? rest(gl) : vertexArray);
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, edgeBuffer);
        gl.glDrawElements(GL3.GL_LINES, 2 * edgeCount, GL3.GL_UNSIGNED_INT, 0);
        objects.drew(2 * edgeCount);
    }

    private int rest(GL3 gl) {
        if (restArray == 0) {
            restArray = objects.vertexArray(gl);
            restBuffer = objects.buffer(gl);
            FloatBuffer at = Buffers.newDirectFloatBuffer(positions.capacity());
            for (int i = 0; i < at.capacity(); i++) {
                at.put(i, (float) surface.rest().positions()[i]);
            }
            gl.glBindVertexArray(restArray);
            objects.fill(gl, GL3.GL_ARRAY_BUFFER, restBuffer, at, GL3.GL_STATIC_DRAW);
            attribute(gl, POSITION, 3, GL3.GL_FLOAT, false);
        }
        return restArray;
    }

    void dispose(GL3 gl) {
        objects.deleteVertexArray(gl, vertexArray);
        objects.deleteVertexArray(gl, restArray);
        for (int buffer : new int[] {
            positionBuffer, normalBuffer, traitBuffer, triangleBuffer, restBuffer, edgeBuffer, quantityBuffer
        }) {
            objects.deleteBuffer(gl, buffer);
        }
    }
}
