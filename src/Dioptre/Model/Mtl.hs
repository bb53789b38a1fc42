{-# LANGUAGE DerivingStrategies #-}
{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Dioptre.Model.Mtl
-- Description : Material libraries of OBJ files
--
-- An OBJ file names its materials; an MTL file says what they are:
--
-- > newmtl gold                    what follows is of the material "gold"
-- > Ka 0.1 0.1 0.1                 its colour in ambient light: red, green, blue, or one number for all three
-- > Kd 0.7 0.6 0.3                 the same for diffused light,
-- > Ks 1 1 1                       and for highlights
-- > Ns 1000                        the exponent of highlights
-- > map_Kd -s 2 2 2 gold leaf.png  a picture in the place of Kd; likewise map_Ka, map_Ks
--
-- Lines with other words are passed over: materials of models mirror nothing and let nothing through. So are the
-- options before the name of a picture. Whatever a material does not say it has from 'unsaid'. A line whose last
-- character is a backslash goes on in the next one. Source: D. Ramey, L. Rose, L. Tyerman, "MTL material format",
-- Alias|Wavefront 1995, <http://paulbourke.net/dataformats/mtl/>.
module Dioptre.Model.Mtl
  ( Mtl (..),
    readMtl,

    -- * The materials of a model
    finishesOf,
    unsaid,
    unknown,
  )
where

import Control.Applicative ((<|>))
import Data.Either (isRight)
import Data.Foldable (asum)
import Data.List (mapAccumL, sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe, isJust, isNothing, listToMaybe, mapMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Encoding as Text
import Dioptre.Light.Colour (Colour (..), black, rgb)
import Dioptre.Light.Finish hiding (finish)
import Dioptre.Model.Obj.Materials (Named (..), defaultMaterial)
import Dioptre.Model.Single (single)
import Dioptre.Source.Diagnostic
import Dioptre.Source.Span (Span (..))
import Dioptre.Source.Text (Source, sourceText)
import Dioptre.Source.Words (Token (..), isBlankInObj, wordsOf)
import Dioptre.Syntax.Value (showReal)

-- | What a library holds.
data Mtl picture = Mtl
  { -- | The materials by their names; of several with one name, the first. Pictures are known by their names first, as the file has them, and where it does.
    mtlMaterials :: Map Text (Finish picture),
    -- | The material of what stands before any @newmtl@, if anything does.
    mtlNameless :: Maybe (Finish picture)
  }
  deriving stock (Eq, Show)

-- | What a material is of which nothing is said.
--
-- Spec: models.mtl.defaults.
unsaid :: Finish picture
unsaid = matt (rgb 0.2 0.2 0.2) (rgb 0.3 0.7 0.3) (rgb 0.2 0.2 0.2)

-- | What stands in for a material that no library has.
--
-- Spec: models.obj.unknown-material.
unknown :: Finish picture
unknown = matt (rgb 0.1 0.1 0.1) (rgb 0.3 0.7 0.3) (rgb 0.05 0.05 0.05)

-- | Ambient, diffuse and specular colour, without pictures; neither a mirror nor transparent.
--
-- Spec: models.mtl.finish.
matt :: Colour -> Colour -> Colour -> Finish picture
matt ambient diffuse specular =
  Finish
    { finishColours = Colours ambient diffuse specular 5,
      finishPictures = NoPictures,
      finishMirror = 0,
      finishTransparency = 0,
      finishTint = black,
      finishIndex = 1
    }

-- | The finishes of the materials of these names, from the first library that has each; and the names that none has,
-- for which 'unknown' stands in. The material @default@ is always there: where none is called so, it is what a library
-- says before any @newmtl@, or else 'unsaid'.
--
-- Spec: models.obj.materials, models.obj.unknown-material.
finishesOf :: [Mtl picture] -> [Text] -> ([Finish picture], [Text])
finishesOf libraries names = (map (fromMaybe unknown . found) names, filter (isNothing . found) names)
  where
    found name = asum [Map.lookup name (mtlMaterials m) | m <- libraries] <|> if name == defaultMaterial then Just nameless else Nothing
    nameless = fromMaybe unsaid (asum (map mtlNameless libraries))

-- | Reads a library. What is wrong is told in the order of the file: 'keptInFull' faults, and the number of the others.
--
-- Spec: models.mtl.keywords.
readMtl :: Source -> (Mtl Named, [Diagnostic])
readMtl source = (Mtl (Map.map fst materials) nameless, bounded (sortOn diagnosticSpan (concat (namelessFaults : faults))))
  where
    (before, named) = break isNew (mapMaybe statement (logicalLines (sourceText source)))
    (beforeFinish, namelessFaults) = finishFrom before
    nameless = if any (isJust . property) before then Just beforeFinish else Nothing
    (materials, faults) = mapAccumL material Map.empty (sections named)

-- | So many faults, and the number of the others at the place of the first of them.
bounded :: [Diagnostic] -> [Diagnostic]
bounded faults = case splitAt keptInFull faults of
  (told, more@(Diagnostic here _ : _)) -> told <> [Diagnostic here (MoreFaults (length more))]
  (told, []) -> told

-------------------------------------------------------------------------------
-- Lines

-- | A line with the lines that it goes on in, each with its number and without the backslash.
type Logical = [(Int, Text)]

-- | The lines of a text; comments do not go on.
logicalLines :: Text -> [Logical]
logicalLines text = joined (zip [1 ..] (Text.split (== '\n') text))
  where
    joined [] = []
    joined ((n, l) : rest)
      | "#" `Text.isPrefixOf` Text.dropWhile isBlankInObj l = joined rest
      | otherwise = case span (("\\" `Text.isSuffixOf`) . snd) ((n, l) : rest) of
        (more, after) -> (map (fmap (Text.dropEnd 1)) more <> take 1 after) : joined (drop 1 after)

-- | A line that says something: its first word, the words behind it, and the line itself, for names with blanks.
data Statement = Statement Token [Token] Logical

-- | What a line says, if it says something.
statement :: Logical -> Maybe Statement
statement l = case concatMap (uncurry (wordsOf isBlankInObj)) l of
  [] -> Nothing
  word : rest -> Just (Statement word rest l)

-- | What stands in a line from this word on, without blanks at its ends: a name.
from :: Token -> Logical -> Text
from (Token place _) l = Text.unwords (filter (not . Text.null) (map (Text.dropAround isBlankInObj) pieces))
  where
    pieces = [if n == spanLine place then Text.drop (spanColumn place - 1) t else t | (n, t) <- l, n >= spanLine place]

-- | The same, with its place: up to the end of the line that it begins in.
nameFrom :: Token -> Logical -> Named
nameFrom t@(Token (Span n start end) _) l = Named (Span n start (maximum (end : lineEnds))) (from t l)
  where
    lineEnds = [Text.length (Text.stripEnd piece) + 1 | (m, piece) <- l, m == n]

-------------------------------------------------------------------------------
-- Materials

-- | Whether a line begins a material.
isNew :: Statement -> Bool
isNew (Statement word _ _) = tokenText word == "newmtl"

-- | Each @newmtl@ with what follows it.
sections :: [Statement] -> [(Statement, [Statement])]
sections [] = []
sections (s : rest) = let (own, others) = break isNew rest in (s, own) : sections others

-- | Adds a material, with the line of its name, to those that there are, unless its name is taken.
material :: Map Text (Finish Named, Int) -> (Statement, [Statement]) -> (Map Text (Finish Named, Int), [Diagnostic])
material known (Statement word rest l, properties) = case (rest, Map.lookup name known) of
  ([], _) -> (known, Diagnostic (tokenSpan word) (RefusedValue "newmtl" NothingThere SomeText (Kept "none")) : faults)
  (t : _, Just (_, first)) -> (known, Diagnostic (tokenSpan t) (RepeatedMaterial name first) : faults)
  (_, Nothing) -> (Map.insert name (finish, spanLine (tokenSpan word)) known, faults)
  where
    name = maybe "" (`from` l) (listToMaybe rest)
    (finish, faults) = finishFrom properties

-- | The finish that these lines describe.
--
-- Spec: models.mtl.finish.
finishFrom :: [Statement] -> (Finish Named, [Diagnostic])
finishFrom = fmap concat . mapAccumL step unsaid
  where
    step finish s = case property s of
      Nothing -> (finish, [])
      Just change -> change finish

-- | What a line does to a finish, and what is wrong with the line; 'Nothing' if its word is none of those that count.
--
-- Spec: models.mtl.keywords, models.mtl.pictures.
property :: Statement -> Maybe (Finish Named -> (Finish Named, [Diagnostic]))
property (Statement word rest l) = case tokenText word of
  "Ka" -> Just (colour finishAmbient withAmbient)
  "Kd" -> Just (colour finishDiffuse withDiffuse)
  "Ks" -> Just (colour finishSpecular withSpecular)
  "Ns" -> Just $ \f -> case traverse amount (take 1 numbers) of
    Right [x] -> (f {finishColours = (finishColours f) {shininessOf = x}}, [])
    Right _ -> (f, [refused (tokenSpan word) NothingThere (ARealNumber (AtLeast "0")) (showReal (shininessOf (finishColours f)))])
    Left (place, why) -> (f, [refused place why (ARealNumber (AtLeast "0")) (showReal (shininessOf (finishColours f)))])
  "map_Ka" -> Just (picture (\name f -> withAmbient (painted name (finishAmbient f)) f))
  "map_Kd" -> Just (picture (\name f -> withDiffuse (painted name (finishDiffuse f)) f))
  "map_Ks" -> Just (picture (\name f -> withSpecular (painted name (finishSpecular f)) f))
  _ -> Nothing
  where
    refused place why wanted kept = Diagnostic place (RefusedValue (tokenText word) why wanted (Kept kept))
    -- A comment may follow them.
    numbers = takeWhile (not . ("#" `Text.isPrefixOf`) . tokenText) rest
    painted name (Layer plain _) = Layer plain (Just name)
    colour layerOf with f =
      let Layer plain painting = layerOf f
          kept = Text.unwords (map showReal [red plain, green plain, blue plain])
          said c = (with (Layer c painting) f, [])
       in case traverse amount (take 3 numbers) of
            Right [r, g, b] -> said (rgb r g b)
            Right [x] -> said (rgb x x x)
            Right [] -> (f, [refused (tokenSpan word) NothingThere AmountsOfLight kept])
            Right xs -> (f, [refused (tokenSpan word) (WrongCount 3 (length xs) NoGuess) AmountsOfLight kept])
            Left (place, why) -> (f, [refused place why AmountsOfLight kept])
    picture with f = case withoutOptions rest of
      [] -> (f, [refused (tokenSpan word) NothingThere SomeText "none"])
      t : _ -> (with (nameFrom t l) f, [])

-- | A number from 0 up; or where there is none, and why.
--
-- Spec: models.mtl.keywords.
amount :: Token -> Either (Span, Refusal) Double
amount (Token place t) = case single (Text.encodeUtf8 t) of
  Left why -> Left (place, why)
  Right x
    | x < 0 -> Left (place, OutOfRange t)
    | otherwise -> Right x

-- | The words of a picture without the options before its name.
--
-- Spec: models.mtl.pictures.
withoutOptions :: [Token] -> [Token]
withoutOptions [] = []
withoutOptions ts@(t : rest)
  | tokenText t `elem` ["-o", "-s", "-t"] = withoutOptions (dropNumbers (3 :: Int) rest)
  | otherwise = maybe ts (\count -> withoutOptions (drop count rest)) (lookup (tokenText t) options)
  where
    -- One to three numbers.
    dropNumbers k (n : ns) | k > 0, isRight (single (Text.encodeUtf8 (tokenText n))) = dropNumbers (k - 1) ns
    dropNumbers _ ns = ns
    options =
      [("-mm", 2)]
        <> [(o, 1) | o <- ["-blendu", "-blendv", "-bm", "-boost", "-cc", "-clamp", "-imfchan", "-texres", "-type"]]
