{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Laws.Obj
-- Description : What is true of reading OBJ files
--
-- Files are made from sketches, lists of what their lines say, from which the mesh follows without reading anything: by
-- list indexing and a count of corners.
module Laws.Obj
  ( -- * Files
    Sketch (..),
    Noise (..),
    Cut (..),
    written,
    fromPieces,
    read1,
    saidOf,

    -- * Laws
    readsWhatIsWritten,
    countsBackwards,
    ignoresTheCut,
    readsAnyLineEnd,
    isSound,
  )
where

import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Char8
import qualified Data.ByteString.Lazy as Lazy
import Data.List (nub)
import Data.Maybe (isNothing)
import Data.Text (Text)
import qualified Data.Vector.Unboxed as Vector
import Dioptre.Geometry.Mesh
import Dioptre.Model.Obj
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Test.QuickCheck

-- | A line: three numbers, two, three; the corners of a face, each with its vertex, and all with texture coordinates or
-- not, with normals or not; a material; or something to pass over.
data Said
  = V Int Int Int
  | T Int Int
  | N Int Int Int
  | F [(Int, Maybe Int, Maybe Int)]
  | Use String
  | Other String
  deriving (Show)

-- | A file without faults. Its vertices are never three on one line, as they lie on a parabola.
newtype Sketch = Sketch [Said]
  deriving (Show)

instance Arbitrary Sketch where
  arbitrary = do
    start <- ([V i (i * i) 0 | i <- [0 .. 3]] <>) <$> ((\n -> [T i 1 | i <- [1 .. n]] <> [N 0 i 1 | i <- [1 .. n]]) <$> choose (0, 3))
    Sketch . (start <>) <$> sized (\size -> choose (0, size) >>= \n -> go n (4, length start - 4))
    where
      go :: Int -> (Int, Int) -> Gen [Said]
      go 0 _ = pure []
      go n (vs, both) = do
        let attributes = both `div` 2
        said <-
          frequency
            [ (2, pure (V vs (vs * vs) 0)),
              (4, face vs attributes),
              (1, Use <$> elements ["gold", "old gold", "stone"]),
              (1, Other <$> elements ["# v 1 2 3", "o thing", "g a b", "s off", "", "l 1 2", "vp 1 2", "fo", "usemtllib a"])
            ]
        (said :) <$> go (n - 1) (case said of V {} -> vs + 1; _ -> vs, both)
      face vs attributes = do
        count <- choose (3, min 7 vs)
        corners <- take count <$> shuffle [1 .. vs]
        uv <- if attributes > 0 then arbitrary else pure False
        n <- if attributes > 0 then arbitrary else pure False
        F <$> mapM (\v -> (,,) v <$> maybeOf uv attributes <*> maybeOf n attributes) corners
      maybeOf have count = if have then Just <$> choose (1, count) else pure Nothing

-- | The file of a sketch; each number of a face goes through a function of how many there are so far.
written :: (Int -> Int -> Int) -> Sketch -> [ByteString]
written index (Sketch said) = zipWith line said (scanl count (0, 0, 0) said)
  where
    count (v, t, n) s = case s of
      V {} -> (v + 1, t, n)
      T {} -> (v, t + 1, n)
      N {} -> (v, t, n + 1)
      _ -> (v, t, n)
    line s (v, t, n) = Char8.pack $ case s of
      V x y z -> unwords ("v" : map show [x, y, z])
      T x y -> unwords ("vt" : map show [x, y])
      N x y z -> unwords ("vn" : map show [x, y, z])
      F corners -> unwords ("f" : map (corner v t n) corners)
      Use name -> "usemtl " <> name
      Other text -> text
    corner v t n c = case c of
      (a, Nothing, Nothing) -> show (index v a)
      (a, Just b, Nothing) -> show (index v a) <> "/" <> show (index t b)
      (a, Nothing, Just d) -> show (index v a) <> "//" <> show (index n d)
      (a, Just b, Just d) -> show (index v a) <> "/" <> show (index t b) <> "/" <> show (index n d)

-- | Lines with line feeds behind them, read.
read1 :: [ByteString] -> Obj
read1 = readObj . Lazy.fromStrict . Char8.unlines

-- | Codes and places of what is wrong.
saidOf :: Obj -> [(Text, Span)]
saidOf o = [(code p, s) | Diagnostic s p <- objDiagnostics o]

-- | The mesh is what the sketch says, and nothing is wrong.
readsWhatIsWritten :: Sketch -> Property
readsWhatIsWritten sketch@(Sketch said) =
  counterexample (show (written forwards sketch)) $
    conjoin
      [ objDiagnostics o === [],
        Vector.toList (meshPoints m) === concat [map fromIntegral [x, y, z] | V x y z <- said],
        Vector.toList (meshUvs m) === concat [map fromIntegral [x, y] | T x y <- said],
        Vector.toList (meshNormals m) === concat [map fromIntegral [x, y, z] | N x y z <- said],
        Vector.toList (meshCorners m) === concat [[pred' a, pred' b, pred' c] | (_, cs) <- triangles, [(a, _, _), (b, _, _), (c, _, _)] <- [cs]],
        attributes (meshCornerUvs m) (\(_, t, _) -> t),
        attributes (meshCornerNormals m) (\(_, _, n) -> n),
        map namedText (objMaterials o) === used,
        map ((used !!) . fromIntegral) (Vector.toList (meshFinishes m)) === [name | (name, _) <- triangles],
        [count (objCounts o) | count <- [countTriangles, countQuads, countPolygons, countErrors, countCollinear]] === [length [() | F cs <- said, fits (length cs)] | fits <- [(== 3), (== 4), (> 4)]] <> [0, 0]
      ]
  where
    o = read1 (written forwards sketch)
    m = objMesh o
    forwards _ i = i
    pred' i = fromIntegral (i - 1)
    faces = go "default" said
    go _ [] = []
    go name (s : rest) = case s of
      Use other -> go other rest
      F corners -> (name, corners) : go name rest
      _ -> go name rest
    used = nub [read (show name) | (name, _) <- faces]
    triangles = [(read (show name), [first, a, b]) | (name, first : others) <- faces, (a, b) <- zip others (drop 1 others)]
    attributes numbers which
      | all (all (isNothing . which) . snd) triangles = Vector.toList numbers === []
      | otherwise = Vector.toList numbers === [maybe noAttribute pred' (which corner) | (_, corners) <- triangles, corner <- corners]

-- | Negative numbers count back from the line.
countsBackwards :: Sketch -> Property
countsBackwards sketch = objMesh (read1 (written backwards sketch)) === objMesh (read1 (written (\_ i -> i) sketch))
  where
    backwards count i = i - count - 1

-- | Bytes of which much looks like an OBJ file.
newtype Noise = Noise ByteString
  deriving (Show)

instance Arbitrary Noise where
  arbitrary = Noise . Bytes.concat <$> listOf piece
    where
      piece =
        frequency
          [ (6, elements ["v ", "vt ", "vn ", "f ", "usemtl ", "mtllib ", "# ", "o "]),
            (6, elements ["1", "-1", "2", "3", "-2", "0", "1e9", "1e39", ".5", "1/1", "1//1", "1/1/1", "-1/-1/-1", "2/", "99999999999999999999", "nan", "a.mtl"]),
            (4, pure " "),
            (6, elements ["\n", "\r\n", "\r", "\\\n", "\\\r\n", "\\"]),
            (2, elements ["v 0 0 0\n", "v 1 0 0\n", "v 0 1 0\n", "vn 0 0 0\n", "vn 0 0 1\n", "vt 1 1\n", "f 1 2 3\n", "f -1 -2 -3\n"]),
            (1, Bytes.singleton <$> arbitrary),
            (1, elements ["\xEF\xBB\xBF", "\xC3\xA9", "\xE9", "\t", "\0"])
          ]
  shrink (Noise b) = [Noise (Bytes.take i b <> Bytes.drop (i + k) b) | k <- takeWhile (> 0) (iterate (`div` 2) (Bytes.length b)), i <- [0, k .. Bytes.length b - 1]]

-- | The lengths of pieces.
newtype Cut = Cut [Int]
  deriving (Show)

instance Arbitrary Cut where
  arbitrary = Cut <$> listOf1 (frequency [(3, choose (1, 3)), (1, choose (0, 40))])

-- | Reads bytes cut into pieces of these lengths, over and over.
fromPieces :: Cut -> ByteString -> Obj
fromPieces (Cut lengths) = readObj . Lazy.fromChunks . pieces (cycle (1 : lengths))
  where
    pieces (n : more) b | not (Bytes.null b) = Bytes.take n b : pieces more (Bytes.drop n b)
    pieces _ _ = []

-- | How a file is cut into pieces changes nothing.
ignoresTheCut :: Cut -> Noise -> Property
ignoresTheCut cut (Noise b) = fromPieces cut b === readObj (Lazy.fromStrict b)

-- | Lines end at CR LF, LF or CR.
readsAnyLineEnd :: Sketch -> Property
readsAnyLineEnd sketch = conjoin [readObj (Lazy.fromStrict (Bytes.concat (map (<> end) said))) === read1 said | end <- ["\r\n", "\r"]]
  where
    said = written (\_ i -> i) sketch

-- | Whatever the bytes, the mesh keeps its promises, and few things are said.
isSound :: Noise -> Property
isSound (Noise b) =
  conjoin
    [ counterexample "corners" (within' 0 (meshCorners m) (Vector.length (meshPoints m) `div` 3)),
      counterexample "normals" (within' noAttribute (meshCornerNormals m) (Vector.length (meshNormals m) `div` 3)),
      counterexample "uvs" (within' noAttribute (meshCornerUvs m) (Vector.length (meshUvs m) `div` 2)),
      counterexample "finishes" (within' 0 (meshFinishes m) (length (objMaterials o))),
      Vector.length (meshCorners m) === 3 * Vector.length (meshFinishes m),
      counterexample "lengths" (all ((`elem` [0, Vector.length (meshCorners m)]) . Vector.length) [meshCornerNormals m, meshCornerUvs m]),
      counterexample "finite" (all (Vector.all (\x -> not (isNaN x || isInfinite x))) [meshPoints m, meshNormals m, meshUvs m]),
      counterexample "few" (length (objDiagnostics o) <= keptInFull + 4),
      counterexample "places" (all (\(_, Span l c e) -> l >= 1 && c >= 1 && e >= c) (saidOf o)),
      counterexample "lines" (all ((`elem` map fst (objLines o)) . spanLine . snd) (saidOf o))
    ]
  where
    o = readObj (Lazy.fromStrict b)
    m = objMesh o
    within' least numbers count = Vector.all (\i -> i >= least && fromIntegral i < count) numbers
