package org.phrenic.mesh.io.dicom;

/**
 * Where the value of an element lies in the file.
 *
 * @param representation value representation as two letters; empty if the file does not state it
 * @param offset first byte of the value
 * @param length bytes of the value, without the delimiter of one of undefined length
 * @param isUndefined whether the file leaves the length open, as for encapsulated pixels
 */
record DicomElement(String representation, int offset, int length, boolean isUndefined) {
    int end() {
        return offset + length;
    }
}
