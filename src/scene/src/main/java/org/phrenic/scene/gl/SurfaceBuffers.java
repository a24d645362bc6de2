package org.phrenic.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.surface.AmbientOcclusion;
import org.phrenic.scene.surface.FieldValues;
import org.phrenic.scene.surface.MeshEdges;
import org.phrenic.scene.surface.VertexAttributes;
import org.phrenic.scene.surface.VertexNormals;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * One surface on the graphics card: positions, normals and traits of its vertices, triangles, and edges once they are
 * asked for.
 */
final class SurfaceBuffers {
    private static final int POSITION = 0;
    private static final int NORMAL = 1;
    private static final int ATTRIBUTES = 2;
    private static final int FIELD = 3;

    /** A surface that encloses a body may have this share of edges with one triangle only. */
    private static final double MAX_OPEN_EDGE_SHARE = 0.02;

    private final GlResources objects;
    private final Surface surface;
    private final int index;
    private final VertexNormals normals;
    private final FloatBuffer positions;
    private final IntBuffer packed;
    private final float[] pose = identity();
    private final int vertexArray;
    private final int positionBuffer;
    private final int normalBuffer;
    private final int attributeBuffer;
    private final int triangleBuffer;
    private final int triangleCount;
    private final boolean closed;
    private int restArray;
    private int restBuffer;
    private int edgeBuffer;
    private int edgeCount;
    private int fieldBuffer;
    private FieldValues values;

    /**
     * @param index of the surface in a frame
     * @param openness where the light that reaches it is looked up
     */
    SurfaceBuffers(GL3 gl, GlResources objects, Surface surface, int index, AmbientOcclusion openness) {
        this.objects = objects;
        this.surface = surface;
        this.index = index;
        TriangleMesh mesh = surface.rest();
        int n = mesh.vertexCount();
        int[] triangles = orientedOutward(mesh);
        normals = new VertexNormals(triangles, n);
        positions = Buffers.newDirectFloatBuffer(3 * n);
        packed = Buffers.newDirectIntBuffer(n);
        for (int i = 0; i < 3 * n; i++) {
            positions.put(i, (float) mesh.positions()[i]);
        }
        normals.compute(positions, packed);
        boolean moving = surface.motion() == Surface.Motion.DEFORMING;
        int usage = moving ? GL3.GL_STREAM_DRAW : GL3.GL_STATIC_DRAW;
        vertexArray = objects.vertexArray(gl);
        positionBuffer = objects.buffer(gl);
        normalBuffer = objects.buffer(gl);
        attributeBuffer = objects.buffer(gl);
        triangleBuffer = objects.buffer(gl);
        triangleCount = triangles.length / 3;
        int[] uses = MeshEdges.triangleCounts(triangles);
        closed = Arrays.stream(uses).filter(count -> count == 1).count() <= MAX_OPEN_EDGE_SHARE * uses.length;
        gl.glBindVertexArray(vertexArray);
        objects.upload(gl, GL3.GL_ARRAY_BUFFER, positionBuffer, positions, usage);
        attribute(gl, POSITION, 3, GL3.GL_FLOAT, false);
        objects.upload(gl, GL3.GL_ARRAY_BUFFER, normalBuffer, packed, usage);
        attribute(gl, NORMAL, 4, GL3.GL_INT_2_10_10_10_REV, true);
        IntBuffer traits = new VertexAttributes(surface).packed(openness.visibility(mesh, normals));
        objects.upload(gl, GL3.GL_ARRAY_BUFFER, attributeBuffer, traits, GL3.GL_STATIC_DRAW);
        attribute(gl, ATTRIBUTES, 4, GL3.GL_UNSIGNED_BYTE, true);
        IntBuffer corners = Buffers.newDirectIntBuffer(triangles);
        objects.upload(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, triangleBuffer, corners, GL3.GL_STATIC_DRAW);
    }

    private static void attribute(GL3 gl, int location, int size, int type, boolean normalized) {
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribPointer(location, size, type, normalized, 0, 0);
    }

    private static float[] identity() {
        return new float[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    }

    /** The triangles, turned round if they look inwards, which files of others may do. */
    private static int[] orientedOutward(TriangleMesh mesh) {
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
                normals.compute(positions, packed);
                objects.stream(gl, positionBuffer, positions);
                objects.stream(gl, normalBuffer, packed);
            }
            case RIGID -> {
                setPose(frame.pose(index));
            }
            case STILL -> {
                // It is where it was.
            }
        }
    }

    /** Puts it somewhere by three rows of four. */
    void setPose(float[] rows) {
        for (int i = 0; i < Frame.POSE_LENGTH; i++) {
            pose[4 * (i % 4) + i / 4] = rows[i];
        }
    }

    /** Sends the values of a quantity. */
    void uploadField(GL3 gl, ColourField field, float[] given) {
        if (values == null) {
            values = new FieldValues(surface);
            fieldBuffer = objects.buffer(gl);
            gl.glBindVertexArray(vertexArray);
            gl.glBindBuffer(GL3.GL_ARRAY_BUFFER, fieldBuffer);
            attribute(gl, FIELD, 1, GL3.GL_FLOAT, false);
        }
        float[] shown =
                switch (field) {
                    case NONE -> values.zeros();
                    case DISTANCE, ACCESS -> given == null ? values.zeros() : given;
                    case STRAIN ->
                        surface.motion() == Surface.Motion.DEFORMING ? values.areaStrain(positions) : values.zeros();
                    case DISPLACEMENT ->
                        switch (surface.motion()) {
                            case DEFORMING -> values.displacement(positions);
                            case RIGID -> values.displacement(poseRows());
                            case STILL -> values.zeros();
                        };
                };
        objects.stream(gl, fieldBuffer, FloatBuffer.wrap(shown));
    }

    private float[] poseRows() {
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
        objects.countDraw(triangleCount);
    }

    /** Draws its edges, where it is now or where it rests. */
    void drawEdges(GL3 gl, boolean atRest) {
        if (edgeBuffer == 0) {
            edgeBuffer = objects.buffer(gl);
            int[] edges = MeshEdges.of(surface.rest().triangles());
            edgeCount = edges.length / 2;
            gl.glBindVertexArray(vertexArray);
            IntBuffer pairs = Buffers.newDirectIntBuffer(edges);
            objects.upload(gl, GL3.GL_ELEMENT_ARRAY_BUFFER, edgeBuffer, pairs, GL3.GL_STATIC_DRAW);
        }
        gl.glBindVertexArray(atRest ? restVertexArray(gl) : vertexArray);
        gl.glBindBuffer(GL3.GL_ELEMENT_ARRAY_BUFFER, edgeBuffer);
        gl.glDrawElements(GL3.GL_LINES, 2 * edgeCount, GL3.GL_UNSIGNED_INT, 0);
        objects.countDraw(2 * edgeCount);
    }

    private int restVertexArray(GL3 gl) {
        if (restArray == 0) {
            restArray = objects.vertexArray(gl);
            restBuffer = objects.buffer(gl);
            FloatBuffer at = Buffers.newDirectFloatBuffer(positions.capacity());
            for (int i = 0; i < at.capacity(); i++) {
                at.put(i, (float) surface.rest().positions()[i]);
            }
            gl.glBindVertexArray(restArray);
            objects.upload(gl, GL3.GL_ARRAY_BUFFER, restBuffer, at, GL3.GL_STATIC_DRAW);
            attribute(gl, POSITION, 3, GL3.GL_FLOAT, false);
        }
        return restArray;
    }

    void dispose(GL3 gl) {
        objects.deleteVertexArray(gl, vertexArray);
        objects.deleteVertexArray(gl, restArray);
        for (int buffer : new int[] {
            positionBuffer, normalBuffer, attributeBuffer, triangleBuffer, restBuffer, edgeBuffer, fieldBuffer
        }) {
            objects.deleteBuffer(gl, buffer);
        }
    }
}
