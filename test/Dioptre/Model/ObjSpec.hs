{-# LANGUAGE OverloadedStrings #-}

module Dioptre.Model.ObjSpec
  ( spec,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import qualified Data.Vector.Unboxed as Vector
import Dioptre.Geometry.Mesh
import Dioptre.Model.Obj
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Laws.Obj
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (mapSize)

spec :: Spec
spec = modifyMaxSuccess (const 400) $ do
  describe "a file without faults" $ do
    prop "is what it says" readsWhatIsWritten
    prop "may count backwards" countsBackwards
    prop "may end its lines in any way" readsAnyLineEnd
    it "may be empty" $ meshSize (objMesh (readObj "")) `shouldBe` 0
  describe "any bytes" $ do
    prop "may come in any pieces" (mapSize (* 2) ignoresTheCut)
    prop "make a mesh that is sound" (mapSize (* 3) isSound)

  describe "numbers" $ do
    it "may be followed by more of them" $
      Vector.toList (meshPoints (objMesh (read1 ["v 1 2 3 0.5", "v 4 5 6 1 0 0 # red"]))) `shouldBe` [1, 2, 3, 4, 5, 6]
    it "are singles" $ Vector.toList (meshPoints (objMesh (read1 ["v 0.1 16777217 -0.3"]))) `shouldBe` [13421773 / 2 ** 27, 16777216, -10066330 / 2 ** 25]
    it "that cannot be read keep their place" $ do
      let o = read1 ["v 0 0 0", "v 1 x 0", "v 1 0 0", "v 0 1 0", "f 1 2 3", "f 1 3 4"]
      corners o `shouldBe` [[0, 2, 3]]
      countErrors (objCounts o) `shouldBe` 1
      objDiagnostics o `shouldBe` [Diagnostic (Span 2 5 6) (BadCoordinates OfVertex (NotANumber "x"))]
      Vector.any isNaN (meshPoints (objMesh o)) `shouldBe` False
    it "may be missing" $
      objDiagnostics (read1 ["v 1 2", "v", "vn 1", "vt", "vt 1", "v 1 1e39 2"])
        `shouldBe` [ Diagnostic (Span 1 1 6) (BadCoordinates OfVertex (WrongCount 3 2 NoGuess)),
                     Diagnostic (Span 2 1 2) (BadCoordinates OfVertex NothingThere),
                     Diagnostic (Span 3 1 5) (BadCoordinates (OfAttribute Normal) (WrongCount 3 1 NoGuess)),
                     Diagnostic (Span 4 1 3) (BadCoordinates (OfAttribute TextureCoordinate) NothingThere),
                     Diagnostic (Span 6 5 9) (BadCoordinates OfVertex (TooLarge "1e39"))
                   ]
    it "of a normal that are all zero, or bad, stand for the flat one" $
      Vector.toList (meshCornerNormals (objMesh (read1 (square <> ["vn 0 0 1", "vn 0 0 0", "vn a b c", "f 1//1 2//2 3//3", "f 1//2 2//3 3//2"])))) `shouldBe` [0, -1, -1, -1, -1, -1]

  describe "faces" $ do
    it "are fans" $ corners (read1 (square <> ["v 0.5 3 0", "f 5 4 1 2 3"])) `shouldBe` [[4, 3, 0], [4, 0, 1], [4, 1, 2]]
    it "have vertices that stand before them" $ do
      let o = read1 (square <> ["f 1 2 5", "f 0 1 2", "f 1 2 -5", "f 1 2 99999999999999999999999", "f 1 2 3", "v 9 9 9"])
      corners o `shouldBe` [[0, 1, 2]]
      countErrors (objCounts o) `shouldBe` 4
      objDiagnostics o
        `shouldBe` [ Diagnostic (Span 5 7 8) (MissingVertex "5" 4),
                     Diagnostic (Span 6 3 4) (MissingVertex "0" 4),
                     Diagnostic (Span 7 7 9) (MissingVertex "-5" 4),
                     Diagnostic (Span 8 7 30) (MissingVertex "99999999999999999999999" 4)
                   ]
    it "go without attributes that are not there, at all their corners" $ do
      let o = read1 (square <> ["vt 0 0", "vn 0 0 1", "f 1/1/1 2/2/1 3/3/1", "f 1/1/1 2/1/1 3/1/-2"])
      Vector.toList (meshCornerUvs (objMesh o)) `shouldBe` [-1, -1, -1, 0, 0, 0]
      Vector.toList (meshCornerNormals (objMesh o)) `shouldBe` [0, 0, 0, -1, -1, -1]
      countErrors (objCounts o) `shouldBe` 2
      objDiagnostics o `shouldBe` [Diagnostic (Span 7 9 14) (MissingAttribute TextureCoordinate "2" 1), Diagnostic (Span 8 15 21) (MissingAttribute Normal "-2" 1)]
    it "are told of at once where the file has no normals" $ do
      let o = read1 (square <> replicate 1000 "f 1//1 2//2 3//3")
      meshSize (objMesh o) `shouldBe` 1000
      Vector.length (meshCornerNormals (objMesh o)) `shouldBe` 0
      countErrors (objCounts o) `shouldBe` 1000
      objDiagnostics o `shouldBe` [Diagnostic (Span 5 3 7) (NoAttributes Normal 1000)]
    it "have corners of one form" $
      objDiagnostics (read1 (square <> ["vt 0 0", "f 1/1 2 3/1", "f 1 2 3/1"]))
        `shouldBe` [Diagnostic (Span 6 7 8) (BadFace (OtherForm "2" "1/1")), Diagnostic (Span 7 7 10) (BadFace (OtherForm "3/1" "1"))]
    it "have corners that can be read" $
      objDiagnostics (read1 (square <> ["f 1 2 x", "f 1 2 3.0", "f 1 /2 3", "f 1/1/1/1 2 3", "f 1 - 2", "f 1 2", "f"]))
        `shouldBe` [ Diagnostic (Span 5 7 8) (BadFace (NotACorner "x")),
                     Diagnostic (Span 6 7 10) (BadFace (NotACorner "3.0")),
                     Diagnostic (Span 7 5 7) (BadFace (NotACorner "/2")),
                     Diagnostic (Span 8 3 10) (BadFace (NotACorner "1/1/1/1")),
                     Diagnostic (Span 9 5 6) (BadFace (NotACorner "-")),
                     Diagnostic (Span 10 1 6) (BadFace (TooFewCorners 2)),
                     Diagnostic (Span 11 1 2) (BadFace (TooFewCorners 0))
                   ]
    it "may leave parts empty, and be followed by a comment" $
      corners (read1 (square <> ["f 1/ 2/ 3/ # first", "f 1// 2// 3//"])) `shouldBe` [[0, 1, 2], [0, 1, 2]]
    it "lose the triangles whose corners are on one line" $ do
      let o = read1 (square <> ["v 2 0 0", "f 1 2 5 3", "f 1 1 1", "f 1 2 2"])
      corners o `shouldBe` [[0, 4, 2]]
      countCollinear (objCounts o) `shouldBe` 3
      objDiagnostics o `shouldBe` [Diagnostic (Span 6 1 10) (CollinearTriangles 3)]
    it "keep triangles as thin as they come" $
      meshSize (objMesh (read1 ["v 0 0 0", "v 1 0 0", "v 0.5 1e-14 0", "f 1 2 3", "v 0 0 1e-44", "v 0 1e-44 0", "f 1 4 5"])) `shouldBe` 2

  describe "materials" $ do
    it "are numbered by their first use" $ do
      let o = read1 (square <> ["f 1 2 3", "usemtl unused", "usemtl  old gold ", "f 1 2 3", "usemtl a", "f 1 2 3", "usemtl old gold", "f 1 2 3", "usemtl default", "f 1 2 3"])
      objMaterials o `shouldBe` [Named (Span 5 1 2) "default", Named (Span 7 9 17) "old gold", Named (Span 9 8 9) "a"]
      Vector.toList (meshFinishes (objMesh o)) `shouldBe` [0, 1, 2, 1, 0]
      lookup 7 (objLines o) `shouldBe` Just "usemtl  old gold "
    it "may have no name" $ do
      let o = read1 (square <> ["usemtl a", "usemtl", "f 1 2 3"])
      map namedText (objMaterials o) `shouldBe` ["default"]
      objDiagnostics o `shouldBe` [Diagnostic (Span 6 1 7) (RefusedValue "usemtl" NothingThere SomeText (Kept "default"))]
    it "have names in any alphabet" $
      map namedText (objMaterials (read1 (square <> ["usemtl doré", "f 1 2 3"]))) `shouldBe` [Text.decodeLatin1 "dor\xe9"]
    it "come from libraries, of which a line names one or several" $
      objLibraries (read1 ["mtllib my colours.mtl", "mtllib a.mtl b c.MTL  d", "mtllib a.mtl"])
        `shouldBe` [Named (Span 1 8 22) "my colours.mtl", Named (Span 2 8 13) "a.mtl", Named (Span 2 14 21) "b c.MTL", Named (Span 2 23 24) "d"]
    it "come from few libraries" $ do
      let o = read1 [Char8.pack ("mtllib " <> show n) | n <- [1 .. mostLibraries + 1]]
      length (objLibraries o) `shouldBe` mostLibraries
      saidOf o `shouldBe` [("too-many-libraries", Span (mostLibraries + 1) 8 11)]

  describe "lines" $ do
    it "go on after a backslash, and keep their places" $ do
      let o = read1 ["v 0 0\\", " 0", "v 1 \\", "\\", "0 0", "v 0 1 0", "f 1 2 \\", "  3", "f 1 2\\", "3 \\", " 9"]
      corners o `shouldBe` [[0, 1, 2]]
      objDiagnostics o `shouldBe` [Diagnostic (Span 11 2 3) (MissingVertex "9" 3)]
      objLines o `shouldBe` [(7, "f 1 2 \\"), (11, " 9")]
    it "do not go on where they are comments" $
      Vector.length (meshPoints (objMesh (read1 ["# C:\\models\\", "v 1 2 3", "  # \\", "v 1 2 3"]))) `shouldBe` 6
    it "may begin with a mark, and with blanks" $
      meshSize (objMesh (readObj (Lazy.fromStrict ("\xEF\xBB\xBF" <> Char8.unlines square <> "\tf 1 2 3")))) `shouldBe` 1
    it "have columns in characters" $
      objDiagnostics (readObj (Lazy.fromStrict (Text.encodeUtf8 "f é 1\n"))) `shouldBe` [Diagnostic (Span 1 3 4) (BadFace (NotACorner "é"))]
    it "are told of twenty times" $ do
      let o = read1 (replicate 50 "v x")
      length (objDiagnostics o) `shouldBe` 21
      drop 20 (objDiagnostics o) `shouldBe` [Diagnostic (Span 21 3 4) (MoreFaults 30)]
      map fst (objLines o) `shouldBe` [1 .. 21]
    it "may be long" $ do
      -- 0 1 2 0 1 2 ...: of three neighbouring pairs only (1, 2) makes a triangle with 0.
      let count = 300000
          o = fromPieces (Cut [999]) (Char8.unlines (square <> ["f" <> Bytes.concat (replicate (count `div` 3) " 1 2 3")]))
      meshSize (objMesh o) `shouldBe` count `div` 3
      countCollinear (objCounts o) `shouldBe` count - 2 - count `div` 3
    it "may be too long" $ do
      let endless = Lazy.fromChunks (replicate (longestLine `div` 65536 + 1) (Char8.replicate 65536 'v'))
          o = readObj ("v 1 2 3\n" <> endless <> "\nv 4 5 6\n")
      objDiagnostics o `shouldBe` [Diagnostic (Span 2 1 1) (LongLine longestLine)]
      Vector.length (meshPoints (objMesh o)) `shouldBe` 6
    it "may go on too far" $ do
      let o = readObj ("v 1 2 3\n" <> Lazy.fromChunks (replicate (mostLines `div` 1024 + 2) (Char8.concat (replicate 1024 "\\\n"))) <> "\nv 4 5 6\n")
      objDiagnostics o `shouldBe` [Diagnostic (Span 2 1 1) (LongLine longestLine)]
      Vector.length (meshPoints (objMesh o)) `shouldBe` 6
    it "are cut before they are shown" $
      map (Text.length . snd) (objLines (read1 ["v " <> Char8.replicate 100000 'x'])) `shouldBe` [4096]
  where
    square = ["v 0 0 0", "v 1 0 0", "v 1 1 0", "v 0 1 0"]
    corners o = [map (fromIntegral . (meshCorners (objMesh o) Vector.!) . (3 * i +)) [0, 1, 2] | i <- [0 .. meshSize (objMesh o) - 1]] :: [[Int]]
